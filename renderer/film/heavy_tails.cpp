#include "renderer/film/heavy_tails.h"

#include <algorithm>
#include <numeric>

#include "renderer/film/tiles.h"

namespace candela {
namespace {

// The light of a pixel or a region, by replicate.
using Shares = std::vector<double>;

void add_pixel(const Film& film, std::size_t i, Shares& shares) {
  for (std::uint32_t r = 0; r < film.replicates(); ++r)
    shares[r] += sum_of_components(film.replicate_sum(i, r));
}

// Whether one replicate holds far more than its share of the samples: of four, half of all. Where
// there is no light, or less than none (filters with negative parts), none does.
bool is_dominated(const Shares& shares) {
  const double fair = 1.0 / static_cast<double>(shares.size());
  const double suspicious = fair + (1 - fair) / 3;
  const double total = std::accumulate(shares.begin(), shares.end(), 0.0);
  const double largest = *std::max_element(shares.begin(), shares.end());
  return shares.size() > 1 && total > 0 && largest > suspicious * total;
}

Shares shares_of(const Film& film, std::size_t i) {
  Shares shares(film.replicates(), 0.0);
  add_pixel(film, i, shares);
  return shares;
}

double mean_light(const Film& film, const PixelRect& region) {
  double light = 0;
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x)
      light += sum_of_components(film.mean(film.index(x, y)));
  return light / (static_cast<double>(region.width()) * region.height());
}

// Where there is so little light that relMSE, whose epsilon is the square of a tenth of the
// picture's mean (compare.h), does not see it: a thousandth of that tenth.
bool is_dim(const Film& film, const PixelRect& region, double picture_mean) {
  constexpr double dimmest = 1e-4;
  return mean_light(film, region) < dimmest * picture_mean;
}

// As a whole, by a firefly; or in most pixels that have any light, each by another one.
bool is_heavy(const Film& film, const PixelRect& region) {
  Shares whole(film.replicates(), 0.0);
  int lit = 0;
  int dominated = 0;
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x) {
      const std::size_t i = film.index(x, y);
      if (max_component(film.mean(i)) > 0) ++lit;
      if (is_dominated(film, i)) ++dominated;
      add_pixel(film, i, whole);
    }
  return is_dominated(whole) || 2 * dominated > lit;
}

}  // namespace

bool is_dominated(const Film& film, std::size_t i) {
  return is_dominated(shares_of(film, i));
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
