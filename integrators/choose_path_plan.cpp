#include "integrators/choose_path_plan.h"

#include <algorithm>
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
constexpr int tile_size = 4;

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
};

Share total(const std::vector<Trials>& tiles, std::optional<Trial> Trials::*trial) {
  const std::vector<double> weights = weights_of(tiles);
  std::vector<double> errors;
  Share sum;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    errors.push_back((tiles[i].*trial)->variance * weights[i]);
    sum.cost += (tiles[i].*trial)->cost;
  }
  sum.error = trimmed_sum(std::move(errors));
  return sum;
}

// See choose_path_plan.h for the letters.
struct Model {
  Share first;                   // A, c0
  Share onward;                  // B, c1 of the first two trials
  std::optional<Share> patient;  // B, c1 of the third

  // What a given error costs.
  [[nodiscard]] double effort(const PathPlan& plan) const {
    const Share& path = patient && plan.roulette_threshold == low_threshold ? *patient : onward;
    const double k = plan.splitting;
    return (first.error + path.error / k) * (first.cost + path.cost * k);
  }
};

Model fit(const std::vector<Trials>& tiles) {
  constexpr double k = trial_splitting;
  const Share whole = total(tiles, &Trials::whole);
  Model model{{}, whole, {}};
  if (tiles.front().split) {
    const Share split = total(tiles, &Trials::split);
    model.onward.error = std::clamp((whole.error - split.error) * k / (k - 1), 0.0, whole.error);
    model.onward.cost = (split.cost - whole.cost) / (k - 1);
    model.first = {whole.error - model.onward.error, whole.cost - model.onward.cost};
  }
  if (tiles.front().patient) {
    const Share patient = total(tiles, &Trials::patient);
    model.patient = {std::max(patient.error - model.first.error, 0.0),
                     patient.cost - model.first.cost};
  }
  return model;
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

PathPlan best_plan(const std::vector<Trials>& tiles, const RenderOptions& options) {
  constexpr double least_gain = 1.05;
  PathPlan best = plan_without_trial(options);
  const Model model = fit(tiles);
  double lowest = model.effort(best) / least_gain;
  for (const PathPlan& plan : plans_of(options)) {
    const double effort = model.effort(plan);
    if (effort >= lowest) continue;
    lowest = effort;
    best = plan;
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
