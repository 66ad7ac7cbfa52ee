#include "integrators/trial.h"

#include <algorithm>
#include <numeric>

#include "renderer/film/film.h"
#include "renderer/image/relmse.h"
#include "renderer/sampling/hash.h"
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
      const auto samples = static_cast<double>(film.samples_by_replicate(i).of(r));
      const Vec3d off = film.replicate_sum(i, r) / samples - mean;
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

Vec3d run_block(TilePass pass, const TrialBlock& place, const RenderOptions& options,
                const TileFunction& render_tile) {
  pass.tile = trial_tile(options, 1, place.seed, place.pixel);
  pass.range = {0, whole_block};
  pass.seed = hash_counter(place.seed, place.sequence);
  Film film(options.width, options.height, pass.tile, 0, 1, film_balance(options));
  render_tile(pass, film);
  return film.mean(0);
}

double picture_samples(const RenderOptions& options) {
  constexpr int surely = 128;  // a pixel
  const int samples = may_end_early(options) ? std::min(options.samples_per_pixel, surely)
                                             : options.samples_per_pixel;
  return static_cast<double>(options.width) * options.height * samples;
}

double relative_weight(double mean, double picture_mean) {
  return 1 / (mean * mean + relmse_epsilon(picture_mean));
}

double relative_noise(const Vec3d& variance, const Vec3d& mean, double picture_mean) {
  double noise = 0;
  for (int c = 0; c < 3; ++c) noise += variance[c] * relative_weight(mean[c], picture_mean);
  return noise;
}

double trimmed_sum(std::vector<double> noise) {
  const auto calm_end = noise.end() - static_cast<std::ptrdiff_t>(noise.size() / noisy_tiles);
  std::nth_element(noise.begin(), calm_end, noise.end());
  return std::accumulate(noise.begin(), calm_end, 0.0);
}

}  // namespace candela
