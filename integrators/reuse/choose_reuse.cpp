#include "integrators/reuse/choose_reuse.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "integrators/path/reuse_groups.h"
#include "integrators/seed_stream.h"
#include "integrators/tile_counts.h"
#include "integrators/trial.h"
#include "renderer/base/parallel.h"
#include "renderer/film/tiles.h"
#include "renderer/sampling/hash.h"

namespace candela {
namespace {

// Means of two blocks of a pixel's samples whose sequences know nothing of each other.
using BlockMeans = std::array<Vec3d, 2>;

struct PixelTrial {
  BlockMeans shared, alone;
  [[nodiscard]] Vec3d mean() const { return (shared[0] + shared[1]) / 2.0; }
};

// With and without what is shared.
struct Pair {
  double shared = 0;
  double alone = 0;
  Pair& operator+=(const Pair& other) {
    shared += other.shared;
    alone += other.alone;
    return *this;
  }
};

struct Group {
  std::vector<PixelTrial> pixels;
  Pair cost;  // of rays
  std::uint64_t samples = 0;
};
constexpr std::uint32_t samples_a_group =  // but at the picture's edges
    2 * whole_block * reuse_group_size;

constexpr std::size_t fewest_groups = 8;

// At most; 0 where they are too few to tell.
std::size_t groups_to_ask(const RenderOptions& options) {
  constexpr double share = 1.0 / 100;
  constexpr double most = 64;
  if (options.samples_per_pixel < static_cast<int>(whole_block)) return 0;
  const auto groups =
      static_cast<std::size_t>(std::min(share * picture_samples(options) / samples_a_group, most));
  return groups < fewest_groups ? 0 : groups;
}

// One of the two blocks of each pixel of a group. `pass`: all but that.
void run_group_block(TilePass pass, std::uint64_t group, std::size_t block,
                     const RenderOptions& options, const TileFunction& render_tile, Group& result) {
  Film shared(options.width, options.height, pass.tile, 0, 1, film_balance(options));
  Film alone = shared;
  const GroupTrial trial{group, &alone};
  pass.trial = &trial;
  const TileCounts counts = render_tile(pass, shared);
  const std::uint64_t cost = cost_of(counts.rays);
  const std::uint64_t of_segments = cost_of({.segment = counts.rays.segment});
  result.cost += {static_cast<double>(cost), static_cast<double>(cost - of_segments)};
  std::size_t pixel = 0;
  for (std::size_t i = 0; i < shared.pixel_count(); ++i) {
    if (shared.samples(i) == 0) continue;  // of another group
    if (pixel == result.pixels.size()) result.pixels.emplace_back();
    PixelTrial& means = result.pixels[pixel++];
    means.shared[block] = shared.mean(i);
    means.alone[block] = alone.mean(i);
    result.samples += shared.samples(i);
  }
}

// Goes on to `count` groups.
void run_groups(const RenderOptions& options, const PathPlan& plan, const TileFunction& render_tile,
                const std::function<bool()>& is_over, std::size_t count,
                std::vector<Group>& groups) {
  const std::uint64_t seed = seed_of(SeedStream::Reuse, options.seed);
  const std::size_t first = groups.size();
  groups.resize(count);
  parallel_for(count - first, [&](std::size_t after_first) {
    if (is_over()) return;
    const std::size_t i = first + after_first;
    const auto index = static_cast<std::uint32_t>(i);
    const PixelRect pixel = trial_tile(options, 1, seed, index);
    TilePass pass;
    pass.tile = square_around(pixel.x0, pixel.y0, reuse_square, options.width, options.height);
    pass.range = {0, whole_block};
    pass.plan = plan;
    for (std::uint32_t block = 0; block < 2; ++block) {
      pass.seed = hash_counter(seed, 2 * index + block);
      run_group_block(pass, hash_counter(seed, ~i), block, options, render_tile, groups[i]);
    }
  });
}

double noise_of_pixel(const BlockMeans& blocks, const Vec3d& mean, double picture_mean) {
  const Vec3d off = blocks[0] - blocks[1];
  return relative_noise(off * off, mean, picture_mean);
}

// Of all but the noisiest pixels.
Pair noise_of(const std::vector<PixelTrial>& pixels) {
  const double picture_mean = mean_of_pixels(pixels);
  if (!(picture_mean > 0)) return {};
  std::vector<Pair> noise;
  for (const PixelTrial& pixel : pixels)
    noise.push_back({noise_of_pixel(pixel.shared, pixel.mean(), picture_mean),
                     noise_of_pixel(pixel.alone, pixel.mean(), picture_mean)});
  std::ranges::sort(noise, {}, [](const Pair& of) { return of.shared + of.alone; });
  noise.resize(noise.size() - noise.size() / noisy_pixels);
  Pair sum;
  for (const Pair& of : noise) sum += of;
  return sum;
}

// Noise times cost.
Pair effort_of(const std::vector<Group>& groups) {
  std::vector<PixelTrial> pixels;
  Pair cost;
  for (const Group& group : groups) {
    pixels.insert(pixels.end(), group.pixels.begin(), group.pixels.end());
    cost += group.cost;
  }
  const Pair noise = noise_of(pixels);
  return {noise.shared * cost.shared, noise.alone * cost.alone};
}

// How much less of it makes sharing pay: error falls faster than as 1 / time.
constexpr double least_gain = 1.2;

// Whether more groups would hardly change what these say. The pixels of a group share their noise,
// so that of n groups is known within a factor of about exp(1 / sqrt(n)).
bool is_clear(const Pair& effort, std::size_t groups) {
  const double factor = std::exp(2 / std::sqrt(static_cast<double>(groups)));
  const double bound = least_gain * effort.shared;
  return effort.alone > factor * bound || factor * effort.alone < bound;
}

}  // namespace

ReuseChoice choose_reuse(const RenderOptions& options, PathPlan plan,
                         const TileFunction& render_tile, const std::function<bool()>& is_over) {
  if (plan.reuses_paths || !options.chooses_reuse) return {plan.reuses_paths};
  plan.reuses_paths = true;
  const std::size_t most = groups_to_ask(options);
  if (most == 0) return {};
  std::vector<Group> groups;
  Pair effort;
  do {
    const std::size_t count = std::min(std::max(fewest_groups, 2 * groups.size()), most);
    run_groups(options, plan, render_tile, is_over, count, groups);
    effort = effort_of(groups);
  } while (groups.size() < most && !is_clear(effort, groups.size()) && !is_over());
  ReuseChoice choice{!is_over() && effort.alone > least_gain * effort.shared};
  for (const Group& group : groups) choice.samples += group.samples;
  return choice;
}

}  // namespace candela
