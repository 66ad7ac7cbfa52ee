#include "integrators/choose_path_plan.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "integrators/trial.h"
#include "renderer/base/parallel.h"
#include "renderer/sampling/hash.h"

namespace candela {
namespace {

constexpr std::uint32_t trial_splitting = 4;  // of the second trial
constexpr float low_threshold = 0.25f;        // of the third
constexpr int tile_size = 2;

// The same tile as it is, with splitting, and with a low roulette threshold.
struct Trials {
  std::optional<Trial> whole;
  std::optional<Trial> split;    // unless there shall be one path
  std::optional<Trial> patient;  // unless the options name a threshold
};

// What relMSE weighs the tiles' variances by.
std::vector<double> weights_of(const std::vector<Trials>& tiles) {
  std::vector<double> means;
  for (const Trials& tile : tiles)
    means.push_back(tile.split ? (tile.whole->mean + tile.split->mean) / 2 : tile.whole->mean);
  const double picture_mean =
      std::accumulate(means.begin(), means.end(), 0.0) / static_cast<double>(tiles.size());
  std::vector<double> weights;
  for (const double mean : means)
    weights.push_back(picture_mean > 0 ? relative_weight(mean, picture_mean) : 0);
  return weights;
}

// A part of the samples: variance and cost.
struct Share {
  double error = 0;
  double cost = 0;

  Share& operator+=(const Share& other) {
    error += other.error;
    cost += other.cost;
    return *this;
  }
};

// See choose_path_plan.h for the letters.
struct Model {
  Share first;    // A, c0
  Share onward;   // B, c1 of the first two trials
  Share patient;  // B, c1 of the third

  // What a given error costs.
  [[nodiscard]] double effort(const PathPlan& plan, bool is_patient) const {
    const Share& path = is_patient ? patient : onward;
    const double k = plan.splitting;
    return (std::max(first.error, 0.0) + std::max(path.error, 0.0) / k) *
           (first.cost + path.cost * k);
  }
};

// Whole and split, the trials have their first hits in common, and of the rest nothing: their
// difference has the variance B + B / k.
Model model_of(const Trials& tile) {
  constexpr double k = trial_splitting;
  const Share whole{tile.whole->variance, tile.whole->cost};
  Model model{{}, whole, {}};
  if (tile.split) {
    model.onward.error = variance_of_difference(*tile.whole, *tile.split) * k / (k + 1);
    model.onward.cost = (tile.split->cost - whole.cost) / (k - 1);
    model.first.error = tile.split->variance - model.onward.error / k;
    model.first.cost = whole.cost - model.onward.cost;
  }
  if (!tile.patient) return model;
  model.patient = {tile.patient->variance, tile.patient->cost - model.first.cost};
  if (tile.split)
    model.patient.error =
        variance_of_difference(*tile.patient, *tile.split) - model.onward.error / k;
  return model;
}

// Sums over the tiles. Errors are those of all but the noisiest, as relMSE weighs them.
Model fit(const std::vector<Trials>& tiles) {
  const std::vector<double> weights = weights_of(tiles);
  std::vector<double> noise;
  for (std::size_t i = 0; i < tiles.size(); ++i)
    noise.push_back(weights[i] *
                    (tiles[i].whole->variance + (tiles[i].split ? tiles[i].split->variance : 0)));
  const std::vector<bool> is_calm = calm_ones(noise);
  Model sum;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    Model tile = model_of(tiles[i]);
    const double weight = is_calm[i] ? weights[i] : 0;
    for (Share* share : {&tile.first, &tile.onward, &tile.patient}) share->error *= weight;
    sum.first += tile.first;
    sum.onward += tile.onward;
    sum.patient += tile.patient;
  }
  return sum;
}

// What the options leave open.
std::vector<PathPlan> plans_of(const RenderOptions& options) {
  std::vector<PathPlan> plans;
  for (const std::uint32_t splitting : {1u, 2u, 4u}) {
    for (const float threshold : {default_roulette_threshold, low_threshold}) {
      PathPlan plan{splitting, threshold};
      if (options.splitting) plan.splitting = static_cast<std::uint32_t>(*options.splitting);
      if (options.roulette_threshold) plan.roulette_threshold = *options.roulette_threshold;
      plans.push_back(plan);
    }
  }
  return plans;
}

// The first hits' noise falls faster than the paths' do, whose many dimensions leave little to
// Sobol points: by n^-3/2, that of edges in two dimensions [He15]. Of the samples of a replicate
// the picture has more than the trial. Counted up to `most`: a lens or a sky's texels do not go on
// like that for ever, and where something else ends the render, only the most samples are known.
double share_of_first_noise(const RenderOptions& options) {
  constexpr double most = 64;
  if (options.sampler == SamplerKind::Independent) return 1;
  const double samples =
      static_cast<double>(options.samples_per_pixel) / std::max(options.replicates, 1);
  return std::min(std::sqrt(double{trial_samples} / trial_replicates / std::min(samples, most)),
                  1.0);
}

PathPlan best_plan(const std::vector<Trials>& tiles, const RenderOptions& options) {
  constexpr double least_gain = 1.05;
  PathPlan best = plan_without_trial(options);
  Model model = fit(tiles);
  model.first.error *= share_of_first_noise(options);
  double lowest = model.effort(best, false) / least_gain;
  for (const PathPlan& plan : plans_of(options)) {
    const bool is_patient = tiles.front().patient && plan.roulette_threshold == low_threshold;
    const double effort = model.effort(plan, is_patient);
    if (effort >= lowest) continue;
    lowest = effort;
    best = plan;
  }
  return best;
}

// How many tiles a trial may have; 0 where they would be too few to tell anything.
std::uint32_t trial_tiles(const RenderOptions& options) {
  constexpr double share = 0.045;
  constexpr double most = 128;
  constexpr double fewest = 64;
  constexpr double paths_a_sample = 1 + trial_splitting + 1;
  constexpr double paths_a_tile = double{tile_size * tile_size} * trial_samples * paths_a_sample;
  const double samples = static_cast<double>(options.width) * options.height *
                         static_cast<double>(options.samples_per_pixel);
  const double tiles = std::min(share * samples / paths_a_tile, most);
  return tiles < fewest ? 0 : static_cast<std::uint32_t>(tiles);
}

}  // namespace

PathPlan plan_without_trial(const RenderOptions& options) {
  return {static_cast<std::uint32_t>(options.splitting.value_or(1)),
          options.roulette_threshold.value_or(default_roulette_threshold)};
}

PathPlan choose_path_plan(const RenderOptions& options, const TileFunction& render_tile,
                          const CancelFlag* cancel) {
  if (options.splitting && options.roulette_threshold) return plan_without_trial(options);
  const std::uint64_t seed = mix_bits(options.seed + 2);  // none that the picture uses
  std::vector<Trials> tiles(trial_tiles(options));
  if (tiles.empty()) return plan_without_trial(options);
  parallel_for(tiles.size(), [&](std::size_t i) {
    if (cancel != nullptr && cancel->load(std::memory_order_relaxed)) return;
    TilePass pass;
    pass.tile = trial_tile(options, tile_size, seed, static_cast<std::uint32_t>(i));
    pass.range = {0, trial_samples};
    pass.seed = seed;
    const auto tried = [&](std::uint32_t splitting, float threshold) {
      pass.plan = {splitting, threshold};
      return run_trial(pass, options, render_tile);
    };
    const float threshold = plan_without_trial(options).roulette_threshold;
    tiles[i].whole = tried(1, threshold);
    if (options.splitting != 1) tiles[i].split = tried(trial_splitting, threshold);
    if (!options.roulette_threshold) tiles[i].patient = tried(1, low_threshold);
  });
  if (cancel != nullptr && cancel->load(std::memory_order_relaxed))
    return plan_without_trial(options);
  return best_plan(tiles, options);
}

}  // namespace candela
