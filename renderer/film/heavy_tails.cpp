#include "renderer/film/heavy_tails.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "renderer/film/tiles.h"

namespace candela {
namespace {

double light_of_replicate(const Film& film, std::size_t i, std::uint32_t r) {
  return sum_of_components(film.replicate_sum(i, r));
}

// Whether one of the replicates holds far more than its share of the samples: of four, half of all.
// Where there is no light, or less than none (filters with negative parts), none does.
bool is_dominant(double largest, double total, std::uint32_t replicates) {
  const double fair = 1.0 / replicates;
  const double suspicious = fair + (1 - fair) / 3;
  return replicates > 1 && total > 0 && largest > suspicious * total;
}

double mean_light(const Film& film, const PixelRect& region) {
  double light = 0;
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x)
      light += sum_of_components(film.mean(film.index(x, y)));
  return light / (static_cast<double>(region.width()) * region.height());
}

// Where there is so little light that relMSE, whose epsilon is the square of a tenth of the
// picture's mean (relmse.h), does not see it: a thousandth of that tenth.
bool is_dim(const Film& film, const PixelRect& region, double picture_mean) {
  constexpr double dimmest = 1e-4;
  return mean_light(film, region) < dimmest * picture_mean;
}

// As a whole, by a firefly; or in most pixels that have any light, each by another one.
bool is_heavy(const Film& film, const PixelRect& region) {
  std::vector<double> whole(film.replicates(), 0.0);  // the region's light
  int lit = 0;
  int dominated = 0;
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x) {
      const std::size_t i = film.index(x, y);
      if (max_component(film.mean(i)) > 0) ++lit;
      if (is_dominated(film, i)) ++dominated;
      for (std::uint32_t r = 0; r < film.replicates(); ++r)
        whole[r] += light_of_replicate(film, i, r);
    }
  const double largest = *std::ranges::max_element(whole);
  const double total = std::accumulate(whole.begin(), whole.end(), 0.0);
  return is_dominant(largest, total, film.replicates()) || 2 * dominated > lit;
}

}  // namespace

bool is_dominated(const Film& film, std::size_t i) {
  double largest = std::numeric_limits<double>::lowest();
  double total = 0;
  for (std::uint32_t r = 0; r < film.replicates(); ++r) {
    const double light = light_of_replicate(film, i, r);
    largest = std::max(largest, light);
    total += light;
  }
  return is_dominant(largest, total, film.replicates());
}

std::vector<bool> heavy_tail_mask(const Film& film) {
  constexpr int region_size = 8;
  std::vector<bool> mask(film.pixel_count(), false);
  const double mean = mean_light(film, film.crop());
  for (const PixelRect& region : tiles_of(film.crop(), region_size)) {
    if (is_dim(film, region, mean) || !is_heavy(film, region)) continue;
    for (int y = region.y0; y < region.y1; ++y)
      for (int x = region.x0; x < region.x1; ++x) mask[film.index(x, y)] = true;
  }
  return mask;
}

}  // namespace candela
