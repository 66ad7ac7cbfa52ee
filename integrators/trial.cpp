#include "integrators/trial.h"

#include <algorithm>

#include "renderer/film/film.h"
#include "renderer/sampling/sampler.h"

namespace candela {
namespace {

constexpr std::uint32_t trial_replicates = 4;

// In bounces. Samples that are skipped count as if they were not: whether they are must not change
// the picture.
double bounces_of(const TileCounts& counts) {
  const std::uint64_t cost = cost_of(counts.rays) + cost_of({.camera = counts.skipped.samples});
  return static_cast<double>(cost) / static_cast<double>(cost_of_bounce);
}

}  // namespace

Trial run_trial(const TilePass& pass, const RenderOptions& options,
                const TileFunction& render_tile) {
  Film film(options.width, options.height, pass.tile, 0, trial_replicates, film_balance(options));
  Trial trial;
  trial.cost = bounces_of(render_tile(pass, film));
  for (std::size_t i = 0; i < film.pixel_count(); ++i) {
    const Vec3d mean = film.mean(i);
    trial.mean += sum_of_components(mean);
    for (std::uint32_t r = 0; r < trial_replicates; ++r) {
      const Vec3d off =
          film.replicate_sum(i, r) / static_cast<double>(film.samples_of_replicate(i, r)) - mean;
      trial.variance += sum_of_components(off * off) / (trial_replicates - 1);
    }
  }
  return trial;
}

PixelRect trial_tile(const RenderOptions& options, int size, std::uint64_t seed,
                     std::uint32_t index) {
  const Vec2f place = Sampler(seed, 0, 0, index).sample_2d(0, Dimension::Filter);
  const int x = static_cast<int>(place.x * static_cast<float>(options.width));
  const int y = static_cast<int>(place.y * static_cast<float>(options.height));
  return {x, y, std::min(x + size, options.width), std::min(y + size, options.height)};
}

double relative_weight(double mean, double picture_mean) {
  return 1 / (mean * mean + 1e-2 * picture_mean * picture_mean);
}

double trimmed_sum(std::vector<double> values) {
  constexpr std::size_t trimmed_share = 16;
  const auto kept = values.end() - static_cast<std::ptrdiff_t>(values.size() / trimmed_share);
  std::sort(values.begin(), values.end());
  double sum = 0;
  for (auto value = values.begin(); value != kept; ++value) sum += *value;
  return sum;
}

}  // namespace candela
