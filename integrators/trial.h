// A few tiles of a picture, spread over all of it, rendered to learn what would be the best way to
// render it. The same for any crop and threads.
#pragma once

#include <cstdint>
#include <vector>

#include "integrators/kernel.h"
#include "integrators/render.h"

namespace candela {

inline constexpr std::uint32_t trial_samples = 16;  // a pixel

inline constexpr std::uint32_t trial_replicates = 4;

struct Trial {
  // Sums over a tile's pixels and channels.
  double mean = 0;
  double variance = 0;            // of what a replicate holds
  double cost = 0;                // in bounces
  std::vector<Vec3d> replicates;  // the pixels' replicates, those of a pixel together
};

// `pass`: with its tile, plan and seed. The film is thrown away.
[[nodiscard]] Trial run_trial(const TilePass& pass, const RenderOptions& options,
                              const TileFunction& render_tile);

// The variance of the difference of what a replicate holds, of two trials in one place: it leaves
// out what they have in common.
[[nodiscard]] double variance_of_difference(const Trial& a, const Trial& b);

// Square but at the picture's edges, at a place that seed and index choose.
[[nodiscard]] PixelRect trial_tile(const RenderOptions& options, int size, std::uint64_t seed,
                                   std::uint32_t index);

// What relMSE weighs a tile's variance by. Means of tiles.
[[nodiscard]] double relative_weight(double mean, double picture_mean);

// All but the noisiest tiles, where a rare bright sample would decide alone.
[[nodiscard]] std::vector<bool> calm_ones(const std::vector<double>& noise);

// Of the calm ones.
[[nodiscard]] double trimmed_sum(const std::vector<double>& noise);

}  // namespace candela
