#include "renderer/film/variance.h"

#include <algorithm>

namespace candela {

std::uint32_t used_replicates(const Film& film, std::size_t i) {
  return std::min(film.samples(i), film.replicates());
}

Vec3d variance_of_mean(const Film& film, std::size_t i) {
  const std::uint32_t count = used_replicates(film, i);
  if (count < 2) return Vec3d(0.0);
  const Vec3d mean = film.mean(i);
  const SamplesByReplicate counts = film.samples_by_replicate(i);
  Vec3d squares(0.0);
  for (std::uint32_t r = 0; r < count; ++r) {
    const double samples = counts.of(r);
    const Vec3d deviation = film.replicate_sum(i, r) * (1 / samples) - mean;
    squares += samples * deviation * deviation;
  }
  return squares / (static_cast<double>(film.samples(i)) * (count - 1));
}

}  // namespace candela
