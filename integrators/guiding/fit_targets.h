// Records of a cell -> where their light came from.
#pragma once

#include <span>

#include "integrators/guiding/guiding_field.h"

namespace candela {

// As seen from the records' middle, the widest and heaviest cluster of directions is halved until
// there are as many as a mixture has, or they are too small to halve. The share stays 0. `records`
// are not empty.
[[nodiscard]] TargetMixture fit_targets(std::span<const TrainingRecord> records);

}  // namespace candela
