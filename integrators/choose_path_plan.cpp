#include "integrators/choose_path_plan.h"

#include <algorithm>
#include <vector>

#include "integrators/trial.h"
#include "renderer/base/parallel.h"
#include "renderer/sampling/hash.h"

namespace candela {
namespace {

constexpr std::uint32_t trial_splitting = 4;  // of the second trial
constexpr float low_threshold = 0.5f;         // of the third
constexpr int tile_size = 4;

// The same tile as it is, with splitting, and with a low roulette threshold.
struct Trials {
  Trial whole;
  Trial split;
  Trial patient;
};

// What relMSE weighs the tiles' variances by.
double weight_of(const Trials& tile, double picture_mean) {
  const double mean = (tile.whole.mean + tile.split.mean) / 2;
  return relative_weight(mean, picture_mean);
}

double weighted_error(const std::vector<Trials>& tiles, Trial Trials::*trial) {
  double picture_mean = 0;
  for (const Trials& tile : tiles) picture_mean += (tile.whole.mean + tile.split.mean) / 2;
  picture_mean /= static_cast<double>(tiles.size());
  if (!(picture_mean > 0)) return 0;
  std::vector<double> errors;
  for (const Trials& tile : tiles)
    errors.push_back((tile.*trial).variance * weight_of(tile, picture_mean));
  return trimmed_sum(std::move(errors));
}

double total_cost(const std::vector<Trials>& tiles, Trial Trials::*trial) {
  double cost = 0;
  for (const Trials& tile : tiles) cost += (tile.*trial).cost;
  return cost;
}

// Of the camera samples, or of one path that goes on from each: variance and cost.
struct Share {
  double error = 0;
  double cost = 0;
};

// See choose_path_plan.h for the letters.
struct Model {
  float threshold = 1;  // of the first two trials
  Share first;          // A, c0
  Share onward;         // B, c1
  Share patient;        // the same of the third trial

  // What a given error costs.
  [[nodiscard]] double effort(const PathPlan& plan) const {
    const Share& path = plan.roulette_threshold == threshold ? onward : patient;
    const double k = plan.splitting;
    return (first.error + path.error / k) * (first.cost + path.cost * k);
  }
};

Model fit(const std::vector<Trials>& tiles, float threshold) {
  constexpr double k = trial_splitting;
  const Share whole{weighted_error(tiles, &Trials::whole), total_cost(tiles, &Trials::whole)};
  const Share split{weighted_error(tiles, &Trials::split), total_cost(tiles, &Trials::split)};
  const Share patient{weighted_error(tiles, &Trials::patient), total_cost(tiles, &Trials::patient)};
  Model model;
  model.threshold = threshold;
  model.onward.error = std::clamp((whole.error - split.error) * k / (k - 1), 0.0, whole.error);
  model.onward.cost = (split.cost - whole.cost) / (k - 1);
  model.first = {whole.error - model.onward.error, whole.cost - model.onward.cost};
  model.patient.error = std::max(patient.error - model.first.error, 0.0);
  model.patient.cost = patient.cost - model.first.cost;
  return model;
}

// What the options leave open, the cheapest sample first.
std::vector<PathPlan> plans_of(const RenderOptions& options) {
  std::vector<PathPlan> plans;
  for (const std::uint32_t splitting : {1u, 2u, 4u}) {
    for (const float threshold : {1.0f, low_threshold}) {
      PathPlan plan{splitting, threshold};
      if (options.splitting) plan.splitting = static_cast<std::uint32_t>(*options.splitting);
      if (options.roulette_threshold) plan.roulette_threshold = *options.roulette_threshold;
      plans.push_back(plan);
    }
  }
  return plans;
}

PathPlan best_plan(const std::vector<Trials>& tiles, const std::vector<PathPlan>& plans) {
  constexpr double least_gain = 1.05;
  PathPlan best = plans.front();
  const Model model = fit(tiles, best.roulette_threshold);
  double lowest = model.effort(best) / least_gain;
  for (const PathPlan& plan : plans) {
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

PathPlan choose_path_plan(const RenderOptions& options, const TileFunction& render_tile,
                          const CancelFlag* cancel) {
  const std::vector<PathPlan> plans = plans_of(options);
  if (options.splitting && options.roulette_threshold) return plans.front();
  const std::uint64_t seed = mix_bits(options.seed + 2);  // none that the picture uses
  std::vector<Trials> tiles(trial_tiles(options));
  if (tiles.empty()) return plans.front();
  parallel_for(tiles.size(), [&](std::size_t i) {
    if (cancel != nullptr && cancel->load(std::memory_order_relaxed)) return;
    TilePass pass;
    pass.tile = trial_tile(options, tile_size, seed, static_cast<std::uint32_t>(i));
    pass.range = {0, trial_samples};
    pass.seed = seed;
    pass.plan.roulette_threshold = plans.front().roulette_threshold;
    tiles[i].whole = run_trial(pass, options, render_tile);
    TilePass split = pass;
    split.plan.splitting = trial_splitting;
    tiles[i].split = run_trial(split, options, render_tile);
    if (options.roulette_threshold) return;
    TilePass patient = pass;
    patient.plan.roulette_threshold = low_threshold;
    tiles[i].patient = run_trial(patient, options, render_tile);
  });
  return best_plan(tiles, plans);
}

}  // namespace candela
