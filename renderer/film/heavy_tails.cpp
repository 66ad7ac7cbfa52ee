#include "renderer/film/heavy_tails.h"

#include "renderer/film/tiles.h"

namespace candela {
namespace {

double sum_of(const Vec3d& v) {
  return v.x + v.y + v.z;
}

// Whether one replicate holds far more of a region's light than its share of the samples: of four,
// half of all.
bool is_heavy(const Film& film, const PixelRect& region) {
  std::vector<double> sums(film.replicates(), 0.0);
  double total = 0;
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x)
      for (std::uint32_t r = 0; r < film.replicates(); ++r)
        sums[r] += sum_of(film.replicate_sum(film.index(x, y), r));
  double most = 0;
  for (const double sum : sums) {
    most = std::max(most, sum);
    total += sum;
  }
  const double fair = 1.0 / film.replicates();
  const double suspicious = fair + (1 - fair) / 3;
  return film.replicates() > 1 && most > suspicious * total;
}

}  // namespace

std::vector<bool> heavy_tail_mask(const Film& film) {
  constexpr int region_size = 8;
  std::vector<bool> mask(film.pixel_count(), false);
  for (const PixelRect& region : tiles_of(film.crop(), region_size)) {
    if (!is_heavy(film, region)) continue;
    for (int y = region.y0; y < region.y1; ++y)
      for (int x = region.x0; x < region.x1; ++x) mask[film.index(x, y)] = true;
  }
  return mask;
}

}  // namespace candela
