// How uncertain a pixel's mean is, from the spread of its replicates.
#pragma once

#include "renderer/film/film.h"

namespace candela {

// The replicates of the i-th pixel that hold samples.
[[nodiscard]] std::uint32_t used_replicates(const Film& film, std::size_t i);

// The variance of the i-th pixel's mean, by channel: unbiased where the replicates hold equally
// many samples, whatever sequence each follows, since they are independent of each other. Elsewhere
// (the count of samples is no multiple of that of the replicates) as if a replicate's variance were
// proportional to 1 / its samples. 0 where fewer than two replicates hold samples: not known.
[[nodiscard]] Vec3d variance_of_mean(const Film& film, std::size_t i);

}  // namespace candela
