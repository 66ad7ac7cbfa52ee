#include "integrators/guiding/choose_guide.h"

#include <algorithm>

#include "integrators/guiding/training.h"
#include "integrators/seed_stream.h"
#include "integrators/trial.h"
#include "renderer/base/parallel.h"

namespace candela {
namespace {

constexpr int tile_size = 2;

// Whole blocks of a share of the picture's samples; 0 where they would be too few to teach
// anything, and not so many that their records would fill the memory.
std::uint64_t training_samples(const RenderOptions& options, double share) {
  constexpr double fewest = 1 << 13;
  constexpr double most = 1 << 19;
  const double samples = std::min(share * picture_samples(options), most);
  return samples < fewest ? 0 : static_cast<std::uint64_t>(samples);
}

// A tile with and without the guide.
struct Pair {
  Trial plain;
  Trial guided;

  [[nodiscard]] double mean() const { return (plain.mean + guided.mean) / 2; }
};

std::vector<Pair> run_pairs(const RenderOptions& options, const TileFunction& render_tile,
                            const GuidingField& field, const std::function<bool()>& is_over) {
  constexpr double share = 0.01;
  constexpr double most = 512;
  constexpr double samples_a_tile = 2.0 * tile_size * tile_size * trial_samples;
  const std::uint64_t seed = seed_of(SeedStream::GuideTrial, options.seed);
  std::vector<Pair> pairs(
      static_cast<std::size_t>(std::min(share * picture_samples(options) / samples_a_tile, most)));
  parallel_for(pairs.size(), [&](std::size_t i) {
    if (is_over()) return;
    TilePass pass;
    pass.tile = trial_tile(options, tile_size, seed, static_cast<std::uint32_t>(i));
    pass.range = {0, trial_samples};
    pass.seed = seed;
    pass.plan = options.plan;
    pairs[i].plain = run_trial(pass, options, render_tile);
    pass.guide = &field;
    pairs[i].guided = run_trial(pass, options, render_tile);
  });
  return pairs;
}

// What a given error costs.
double effort(const std::vector<Pair>& pairs, double picture_mean, Trial Pair::*trial) {
  double cost = 0;
  std::vector<double> errors;
  for (const Pair& pair : pairs) {
    cost += (pair.*trial).cost;
    errors.push_back((pair.*trial).variance * relative_weight(pair.mean(), picture_mean));
  }
  return cost * trimmed_sum(errors);
}

bool pays(const std::vector<Pair>& pairs) {
  constexpr double guided_bounce = 1.2;  // what it costs, in others
  constexpr double least_gain = 1.1;     // training takes time, too, and trials are noisy
  double picture_mean = 0;
  for (const Pair& pair : pairs) picture_mean += pair.mean() / static_cast<double>(pairs.size());
  if (!(picture_mean > 0)) return false;
  return effort(pairs, picture_mean, &Pair::plain) >
         least_gain * guided_bounce * effort(pairs, picture_mean, &Pair::guided);
}

}  // namespace

GuideChoice choose_guide(const RenderOptions& options, const TileFunction& render_tile,
                         const std::function<bool()>& is_over) {
  constexpr double first_share = 0.02, whole_share = 0.08, share_if_on = 0.1;
  if (options.guiding == Guiding::Off) return {};
  const bool is_on = options.guiding == Guiding::On;
  Training training(options, render_tile, is_over);
  training.run_until(training_samples(options, is_on ? share_if_on : first_share));
  const auto has_learned = [&] { return training.field().guided_cells() > 0; };
  if (!is_on && has_learned()) {
    const std::vector<Pair> pairs = run_pairs(options, render_tile, training.field(), is_over);
    if (is_over() || !pays(pairs)) return {nullptr, training.samples()};
    training.run_until(training_samples(options, whole_share));
  }
  if (!has_learned()) return {nullptr, training.samples()};
  return {std::make_shared<const GuidingField>(training.field()), training.samples()};
}

}  // namespace candela
