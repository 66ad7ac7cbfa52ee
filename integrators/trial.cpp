#include "integrators/trial.h"

#include <algorithm>
#include <numeric>

#include "renderer/film/film.h"
#include "renderer/sampling/sampler.h"

namespace candela {
namespace {

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
      const Vec3d replicate =
          film.replicate_sum(i, r) / static_cast<double>(film.samples_of_replicate(i, r));
      const Vec3d off = replicate - mean;
      trial.variance += sum_of_components(off * off) / (trial_replicates - 1);
      trial.replicates.push_back(replicate);
    }
  }
  return trial;
}

double variance_of_difference(const Trial& a, const Trial& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.replicates.size(); ++i) {
    const Vec3d difference = a.replicates[i] - b.replicates[i];  // its expectation is 0
    sum += sum_of_components(difference * difference);
  }
  return sum / trial_replicates;
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

std::vector<bool> calm_ones(const std::vector<double>& noise) {
  constexpr std::size_t noisy_share = 16;
  std::vector<std::size_t> order(noise.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return noise[a] < noise[b]; });
  std::vector<bool> is_calm(noise.size(), true);
  for (std::size_t i = noise.size() - noise.size() / noisy_share; i < noise.size(); ++i)
    is_calm[order[i]] = false;
  return is_calm;
}

double trimmed_sum(const std::vector<double>& noise) {
  const std::vector<bool> is_calm = calm_ones(noise);
  double sum = 0;
  for (std::size_t i = 0; i < noise.size(); ++i)
    if (is_calm[i]) sum += noise[i];
  return sum;
}

}  // namespace candela
