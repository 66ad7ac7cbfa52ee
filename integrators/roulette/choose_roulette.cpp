#include "integrators/roulette/choose_roulette.h"

#include <algorithm>
#include <array>

#include "integrators/roulette/walk_log.h"
#include "integrators/seed_stream.h"
#include "integrators/tile_counts.h"
#include "integrators/trial.h"
#include "renderer/base/parallel.h"

namespace candela {
namespace {

struct Block {
  std::vector<Walk> walks;  // none where nothing but the background is seen
  Vec3d mean{0};
  std::uint32_t samples = 0;  // none where the time was over
};

// Walks that roulette leaves alone for long, in two blocks whose sequences know nothing of each
// other.
struct PixelWalks {
  std::array<Block, 2> blocks;
  [[nodiscard]] Vec3d mean() const { return (blocks[0].mean + blocks[1].mean) / 2.0; }
};
constexpr std::uint32_t samples_a_pixel = 2 * whole_block;

std::size_t pixels_to_ask(const RenderOptions& options) {
  constexpr double share = 1.0 / 400;
  constexpr double fewest = 1 << 10, most = 1 << 13;
  const double samples = std::min(share * picture_samples(options), most);
  return samples < fewest ? 0 : static_cast<std::size_t>(samples) / samples_a_pixel;
}

Block walk_block(const RenderOptions& options, const TileFunction& render_tile,
                 const TrialBlock& place) {
  WalkLog log;
  TilePass pass;
  pass.plan.roulette_threshold = 1.0f / 16;
  pass.observer = &log;
  const Vec3d mean = run_block(pass, place, options, render_tile);
  if (const auto balance = film_balance(options))
    for (Walk& walk : log.walks()) walk.multiply_radiance(*balance);
  return {std::move(log.walks()), mean, whole_block};
}

std::vector<PixelWalks> walk_pixels(const RenderOptions& options, const TileFunction& render_tile,
                                    const std::function<bool()>& is_over) {
  const std::uint64_t seed = seed_of(SeedStream::Roulette, options.seed);
  std::vector<PixelWalks> pixels(pixels_to_ask(options));
  parallel_for(pixels.size(), [&](std::size_t i) {
    if (is_over()) return;
    const auto pixel = static_cast<std::uint32_t>(i);
    for (std::uint32_t block = 0; block < 2; ++block)
      pixels[i].blocks[block] = walk_block(options, render_tile, {seed, pixel, 2 * pixel + block});
  });
  return pixels;
}

std::uint64_t samples_of(const std::vector<PixelWalks>& pixels) {
  std::uint64_t samples = 0;
  for (const PixelWalks& pixel : pixels)
    for (const Block& block : pixel.blocks) samples += block.samples;
  return samples;
}

// What a sample has: variance as relMSE weighs it, and cost.
struct Effort {
  double variance = 0;
  double cost = 0;
};

// The two blocks tell the variance with the walks' own roulette, which knows how well Sobol points
// are spread; the walks what another one changes.
Effort effort_of(const PixelWalks& pixel, double picture_mean, Roulette roulette) {
  const double camera_cost = static_cast<double>(cost_of({.camera = 1, .shadow = 1}));
  const double bounce_cost = static_cast<double>(cost_of({.indirect = 1, .shadow = 1}));
  const Vec3d off = pixel.blocks[0].mean - pixel.blocks[1].mean;
  Vec3d variance = static_cast<double>(whole_block) / 2 * off * off;
  double cost = 0;
  for (const Block& block : pixel.blocks)
    for (const Walk& walk : block.walks) {
      if (walk.steps.empty())
        continue;  // into the sky: of little cost, and skipped by some kernels
      const RouletteOutcome outcome = expected_under(walk, roulette);
      variance += outcome.variance / static_cast<double>(samples_a_pixel);
      cost += (camera_cost + bounce_cost * outcome.bounces) / samples_a_pixel;
    }
  return {relative_noise(variance, pixel.mean(), picture_mean), cost};
}

// Relative variance times cost of all but the noisiest pixels.
class Efforts {
 public:
  Efforts(std::vector<PixelWalks> pixels, Roulette usual)
      : pixels_(std::move(pixels)), picture_mean_(mean_of_pixels(pixels_)) {
    if (!has_light()) return;
    std::vector<std::pair<double, std::size_t>> noise;
    for (std::size_t i = 0; i < pixels_.size(); ++i)
      noise.emplace_back(effort_of(pixels_[i], picture_mean_, usual).variance, i);
    std::ranges::sort(noise);
    noise.resize(noise.size() - noise.size() / noisy_pixels);
    for (const auto& [variance, i] : noise) calm_.push_back(i);
  }

  [[nodiscard]] bool has_light() const { return picture_mean_ > 0; }
  [[nodiscard]] double with(Roulette roulette) const {
    Effort sum;
    for (const std::size_t i : calm_) {
      const Effort effort = effort_of(pixels_[i], picture_mean_, roulette);
      sum.variance += effort.variance;
      sum.cost += effort.cost;
    }
    return sum.variance * sum.cost;
  }

 private:
  std::vector<PixelWalks> pixels_;
  double picture_mean_;
  std::vector<std::size_t> calm_;
};

}  // namespace

RouletteChoice choose_roulette(const RenderOptions& options, const TileFunction& render_tile,
                               const std::function<bool()>& is_over) {
  constexpr double least_gain = 1.05;
  RouletteChoice choice{options.plan};
  if (!options.chooses_roulette) return choice;
  std::vector<PixelWalks> pixels = walk_pixels(options, render_tile, is_over);
  choice.samples = samples_of(pixels);
  if (is_over()) return choice;
  const Efforts efforts(std::move(pixels), options.plan.roulette());
  if (!efforts.has_light()) return choice;
  double least = efforts.with(options.plan.roulette()) / least_gain;
  for (const std::uint32_t first_bounce : {2u, 1u, 0u})
    for (const float threshold : {0.5f, 0.25f}) {
      PathPlan plan = options.plan;
      plan.roulette_threshold = threshold;
      plan.first_roulette_bounce = first_bounce;
      const double effort = efforts.with(plan.roulette());
      if (!(effort < least)) continue;
      least = effort;
      choice.plan = plan;
    }
  return choice;
}

}  // namespace candela
