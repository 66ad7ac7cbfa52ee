#include "integrators/choose_splitting.h"

#include <algorithm>
#include <vector>

#include "renderer/base/parallel.h"
#include "renderer/film/film.h"
#include "renderer/sampling/hash.h"
#include "renderer/sampling/sampler.h"

namespace candela {
namespace {

constexpr std::uint32_t trial_replicates = 4;
constexpr std::uint32_t trial_samples = 16;
constexpr std::uint32_t trial_splitting = 4;  // of the second trial
constexpr int tile_size = 4;

// A trial of one tile: sums over its pixels and channels.
struct Trial {
  double mean = 0;
  double variance = 0;  // of what a replicate holds
  double cost = 0;
};

Trial operator+(const Trial& a, const Trial& b) {
  return {a.mean + b.mean, a.variance + b.variance, a.cost + b.cost};
}

double sum_of(const Vec3d& v) {
  return v.x + v.y + v.z;
}

// In bounces: fitted to the times of twelve scenes with and without splitting (docs/decisions.md).
// Samples that are skipped count as if they were not: whether they are must not change the picture.
double cost_of(const TileCounts& counts) {
  return 0.55 * static_cast<double>(counts.rays.camera + counts.skipped.samples) +
         static_cast<double>(counts.rays.indirect) + 0.1 * static_cast<double>(counts.rays.shadow);
}

Trial run_trial(const TilePass& pass, const RenderOptions& options,
                const TileFunction& render_tile) {
  Film film(options.width, options.height, pass.tile, 0, trial_replicates);
  Trial trial;
  trial.cost = cost_of(render_tile(pass, film));
  for (std::size_t i = 0; i < film.pixel_count(); ++i) {
    const Vec3d mean = film.mean(i);
    trial.mean += sum_of(mean);
    for (std::uint32_t r = 0; r < trial_replicates; ++r) {
      const Vec3d off =
          film.replicate_sum(i, r) / static_cast<double>(film.samples_of_replicate(i, r)) - mean;
      trial.variance += sum_of(off * off) / (trial_replicates - 1);
    }
  }
  return trial;
}

// The same tile without and with splitting.
struct TrialPair {
  Trial whole;
  Trial split;
};

// What relMSE weighs the tiles' variances by.
double weight_of(const TrialPair& tile, double picture_mean) {
  const double mean = (tile.whole.mean + tile.split.mean) / 2;
  return 1 / (mean * mean + 1e-2 * picture_mean * picture_mean);
}

// Without the noisiest tiles, where a rare bright sample would decide alone.
double trimmed_sum(std::vector<double> values) {
  constexpr std::size_t trimmed_share = 16;
  const auto kept = values.end() - static_cast<std::ptrdiff_t>(values.size() / trimmed_share);
  std::sort(values.begin(), values.end());
  double sum = 0;
  for (auto value = values.begin(); value != kept; ++value) sum += *value;
  return sum;
}

// See choose_splitting.h for the letters.
std::uint32_t best_splitting(const std::vector<TrialPair>& tiles) {
  TrialPair all;
  for (const TrialPair& tile : tiles) all = {all.whole + tile.whole, all.split + tile.split};
  const double picture_mean =
      (all.whole.mean + all.split.mean) / (2 * static_cast<double>(tiles.size()));
  if (!(picture_mean > 0)) return 1;
  std::vector<double> whole_errors, split_errors;
  for (const TrialPair& tile : tiles) {
    whole_errors.push_back(tile.whole.variance * weight_of(tile, picture_mean));
    split_errors.push_back(tile.split.variance * weight_of(tile, picture_mean));
  }
  constexpr double k = trial_splitting;
  const double whole_error = trimmed_sum(whole_errors);
  const double b =
      std::clamp((whole_error - trimmed_sum(split_errors)) * k / (k - 1), 0.0, whole_error);
  const double a = whole_error - b;
  const double c1 = (all.split.cost - all.whole.cost) / (k - 1);
  const double c0 = all.whole.cost - c1;

  constexpr double least_gain = 1.05;
  std::uint32_t best = 1;
  double lowest = (a + b) * (c0 + c1) / least_gain;
  for (const std::uint32_t splitting : {2u, 4u}) {
    const double effort = (a + b / splitting) * (c0 + c1 * splitting);
    if (effort >= lowest) continue;
    lowest = effort;
    best = splitting;
  }
  return best;
}

// How many tiles a trial may have; 0 where they would be too few to tell anything.
std::uint32_t trial_tiles(const RenderOptions& options) {
  constexpr double share = 0.03;
  constexpr double most = 128;
  constexpr double fewest = 16;
  constexpr double samples_a_tile = double{tile_size * tile_size} * trial_samples * trial_splitting;
  const double samples = static_cast<double>(options.width) * options.height *
                         static_cast<double>(options.samples_per_pixel);
  const double tiles = std::min(share * samples / samples_a_tile, most);
  return tiles < fewest ? 0 : static_cast<std::uint32_t>(tiles);
}

PixelRect trial_tile(const RenderOptions& options, std::uint64_t seed, std::uint32_t index) {
  const Vec2f place = Sampler(seed, 0, 0, index).sample_2d(0, Dimension::Filter);
  const int x = static_cast<int>(place.x * static_cast<float>(options.width));
  const int y = static_cast<int>(place.y * static_cast<float>(options.height));
  return {x, y, std::min(x + tile_size, options.width), std::min(y + tile_size, options.height)};
}

}  // namespace

std::uint32_t choose_splitting(const RenderOptions& options, const TileFunction& render_tile,
                               const CancelFlag* cancel) {
  const std::uint64_t seed = mix_bits(options.seed + 2);  // none that the picture uses
  std::vector<TrialPair> tiles(trial_tiles(options));
  if (tiles.empty()) return 1;
  parallel_for(tiles.size(), [&](std::size_t i) {
    if (cancel != nullptr && cancel->load(std::memory_order_relaxed)) return;
    TilePass pass;
    pass.tile = trial_tile(options, seed, static_cast<std::uint32_t>(i));
    pass.range = {0, trial_samples};
    pass.seed = seed;
    tiles[i].whole = run_trial(pass, options, render_tile);
    pass.splitting = trial_splitting;
    tiles[i].split = run_trial(pass, options, render_tile);
  });
  return best_splitting(tiles);
}

}  // namespace candela
