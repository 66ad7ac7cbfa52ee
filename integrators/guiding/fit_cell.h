// What the records of a cell of space teach.
#pragma once

#include <span>

#include "integrators/guiding/guiding_field.h"

namespace candela {

// The mixture, and which share of the paths should follow it: of a few the one that would have made
// the mean square of what they bring least [Rath20, section 4]. Each half of the records judges a
// mixture that the other half taught, since a mixture flatters its own. `records` are not empty.
[[nodiscard]] TargetMixture fit_cell(std::span<const TrainingRecord> records);

}  // namespace candela
