// A few tiles or pixels of a picture, spread over all of it, rendered to learn what would be the
// best way to render it. The same for any crop and threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "integrators/kernel.h"
#include "integrators/render_options.h"
#include "renderer/math/vec.h"

namespace candela {

inline constexpr std::uint32_t trial_samples = 16;  // a pixel

inline constexpr std::uint32_t trial_replicates = 4;

struct Trial {
  // Sums over a tile's pixels and channels.
  double mean = 0;
  double variance = 0;  // of what a replicate holds
  double cost = 0;      // in bounces
};

// `pass`: with its tile, plan and seed. The film is thrown away.
[[nodiscard]] Trial run_trial(const TilePass& pass, const RenderOptions& options,
                              const TileFunction& render_tile);

// Square but at the picture's edges, at a place that seed and index choose.
[[nodiscard]] PixelRect trial_tile(const RenderOptions& options, int size, std::uint64_t seed,
                                   std::uint32_t index);

// One of the pixels that a seed spreads over the picture, and its random numbers.
struct TrialBlock {
  std::uint64_t seed = 0;
  std::uint32_t pixel = 0;
  std::uint32_t sequence = 0;
};

// A whole block of the samples of one pixel, of which the pass' observer is told, in colours before
// the film's balance; returns their mean, which has it.
Vec3d run_block(TilePass pass, const TrialBlock& place, const RenderOptions& options,
                const TileFunction& render_tile);

// Camera samples of the picture; where other rules than their number end it, what it has at least.
[[nodiscard]] double picture_samples(const RenderOptions& options);

// What relMSE weighs a variance by; a pixel's variance as relMSE weighs it.
[[nodiscard]] double relative_weight(double mean, double picture_mean);
[[nodiscard]] double relative_noise(const Vec3d& variance, const Vec3d& mean, double picture_mean);

// One tile or pixel in so many is left out of what is compared, the noisiest, where a rare bright
// sample would decide alone.
inline constexpr std::size_t noisy_tiles = 16;
inline constexpr std::size_t noisy_pixels = 32;

// Of all tiles but the noisiest of them.
[[nodiscard]] double trimmed_sum(std::vector<double> noise);

// `pixels`: each has a mean(). 0: there are none.
template <class Pixels>
[[nodiscard]] double mean_of_pixels(const Pixels& pixels) {
  double mean = 0;
  for (const auto& pixel : pixels)
    mean += sum_of_components(pixel.mean()) / 3 / static_cast<double>(pixels.size());
  return mean;
}

}  // namespace candela
