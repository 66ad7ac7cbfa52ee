#include "renderer/film/pixel_interval.h"

#include <algorithm>
#include <cmath>

#include "renderer/film/student_t.h"
#include "renderer/film/variance.h"

namespace candela {
namespace {

// Of one sample, pooled: weighted by the degrees of freedom that it comes from.
struct Pooled {
  Vec3d sum{0.0};
  double degrees = 0;

  void add(const Film& film, std::size_t i) {
    const std::uint32_t replicates = used_replicates(film, i);
    if (replicates < 2) return;
    const double own = replicates - 1;
    sum += own * static_cast<double>(film.samples(i)) * variance_of_mean(film, i);
    degrees += own;
  }
};

Vec3d half_width(const Film& film, int x, int y) {
  const PixelRect& crop = film.crop();
  Pooled pooled;
  for (int v = std::max(y - 1, crop.y0); v <= std::min(y + 1, crop.y1 - 1); ++v)
    for (int u = std::max(x - 1, crop.x0); u <= std::min(x + 1, crop.x1 - 1); ++u)
      pooled.add(film, film.index(u, v));
  const std::size_t i = film.index(x, y);
  if (used_replicates(film, i) < 2) return Vec3d(0.0);
  const Vec3d variance = pooled.sum / (pooled.degrees * static_cast<double>(film.samples(i)));
  const double t = student_t_95(pooled.degrees);
  return {t * std::sqrt(variance.x), t * std::sqrt(variance.y), t * std::sqrt(variance.z)};
}

}  // namespace

std::vector<Vec3d> pixel_intervals(const Film& film) {
  std::vector<Vec3d> intervals;
  intervals.reserve(film.pixel_count());
  const PixelRect& crop = film.crop();
  for (int y = crop.y0; y < crop.y1; ++y)
    for (int x = crop.x0; x < crop.x1; ++x) intervals.push_back(half_width(film, x, y));
  return intervals;
}

}  // namespace candela
