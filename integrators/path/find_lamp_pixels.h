// Which pixels are to have more camera rays for lamps, and how many, before any sample is drawn.
#pragma once

#include <algorithm>

#include "integrators/lamp_pixels.h"
#include "integrators/path/seen_lamps.h"
#include "renderer/base/parallel.h"
#include "renderer/sampling/hash.h"

namespace candela {

// How much of a pixel lamps cover, as far as the trial's rays can tell.
enum class LampCoverage : std::uint8_t { None, Part, All };

template <FeatureSet F, class A>
[[nodiscard]] LampCoverage lamp_coverage(const PathContext<A>& context, const PixelSampler& pixel,
                                         int x, int y, std::uint32_t blocks) {
  bool any = false;
  bool all = true;
  RayBlock rays;
  for (std::uint32_t block = 0; block < blocks; ++block) {
    const SamplerBlock samplers(pixel, block * block_size);
    const LaneMask traced = aim_at_lamps<F>(context, samplers, x, y, all_lanes, rays);
    const HitBlock hits = intersect_lanes(context.accelerator, rays, traced, 0, true);
    for_each_lane(traced, [&](std::uint32_t i) {
      const bool is_lit =
          !is_black(lamp_radiance<F>(context.scene, context.options, rays[i], hits[i]));
      any |= is_lit;
      all &= is_lit;
    });
  }
  if (!any) return LampCoverage::None;
  return all ? LampCoverage::All : LampCoverage::Part;
}

// Where lamps may be seen, and how many blocks of sixteen rays look at each of these pixels; 0:
// nowhere, or it would take too long.
struct LampTrial {
  PixelMask pixels;
  std::uint32_t blocks = 0;
};
[[nodiscard]] LampTrial plan_lamp_trial(const Scene& scene, const Filter& filter,
                                        const RenderOptions& options);

// Pixels that are not covered like all of their neighbours: what the trial missed of a lamp's edge
// lies beside what it found.
[[nodiscard]] LampPixels lamp_edges(const std::vector<LampCoverage>& coverage,
                                    const RenderOptions& options);

// Of the whole picture, by random numbers of its own: the same for any crop and threads. None in
// scenes with media, with filters that have negative parts, or where finding out would take long.
template <FeatureSet F, class A>
[[nodiscard]] LampPixels find_lamp_pixels(const PathContext<A>& context) {
  const RenderOptions& options = context.options;
  const LampTrial trial = plan_lamp_trial(context.scene, context.filter, options);
  if (trial.blocks == 0) return {};
  const std::uint64_t seed = mix_bits(options.seed + 3);  // none that the picture uses
  std::vector<LampCoverage> coverage(trial.pixels.size(), LampCoverage::None);
  const auto width = static_cast<std::size_t>(options.width);
  parallel_for(static_cast<std::size_t>(options.height), [&](std::size_t y) {
    for (std::size_t x = 0; x < width; ++x) {
      if (trial.pixels[y * width + x] == 0) continue;
      const PixelSampler pixel(seed, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                               1);
      coverage[y * width + x] =
          lamp_coverage<F>(context, pixel, static_cast<int>(x), static_cast<int>(y), trial.blocks);
    }
  });
  return lamp_edges(coverage, options);
}

}  // namespace candela
