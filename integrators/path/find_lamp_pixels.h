// Which pixels are to have more camera rays for lamps, and how many, before any sample is drawn.
#pragma once

#include <algorithm>
#include <functional>

#include "integrators/lamp_pixels.h"
#include "integrators/path/seen_lamps.h"
#include "integrators/pixel_cover.h"
#include "integrators/seed_stream.h"
#include "renderer/base/parallel.h"
#include "renderer/sampling/hash.h"

namespace candela {

// How much of a pixel lamps cover, as far as the trial's rays can tell.
enum class LampCoverage : std::uint8_t { None, Part, All };

template <FeatureSet F, class A>
[[nodiscard]] LampCoverage lamp_coverage(const PathContext<A>& context, const PixelSampler& pixel,
                                         const FilterPart& part, int x, int y,
                                         std::uint32_t blocks) {
  bool any = false;
  bool all = part.is_whole();
  RayBlock rays;
  for (std::uint32_t block = 0; block < blocks; ++block) {
    const BlockPlace place = place_in_pixel(context.options, x, y, block * block_size, all_lanes);
    const SamplerBlock samplers(pixel, place.samples[0]);
    const LaneMask traced = aim_at_lamps(context, samplers, part, place.pixels, place.lanes, rays);
    const HitBlock hits = intersect_lanes(context.accelerator, rays, traced, 0);
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
  std::vector<LampView> views;
  std::uint32_t blocks = 0;
};
[[nodiscard]] LampTrial plan_lamp_trial(const Scene& scene, const Filter& filter,
                                        const RenderOptions& options,
                                        const std::function<bool()>& is_over);

// Pixels, in rows of `width`, that are not covered like all of their neighbours: what the trial
// missed of a lamp's edge lies beside what it found.
[[nodiscard]] PixelMask lamp_edges(const std::vector<LampCoverage>& coverage, int width,
                                   int height);

// The most rays a sample of so many pixels that take at most an eighth or so of the picture's time,
// by twos; 0: more than one would take longer.
[[nodiscard]] std::uint32_t affordable_lamp_rays(std::size_t pixels, const RenderOptions& options);

// Of the whole picture, by random numbers of its own: the same for any crop and threads. None in
// scenes with media, with filters that have negative parts, or where finding out would take long.
// `is_over`: asked now and then whether to give up; then none, too.
template <FeatureSet F, class A>
[[nodiscard]] LampPixels find_lamp_pixels(const PathContext<A>& context,
                                          const std::function<bool()>& is_over) {
  const RenderOptions& options = context.options;
  LampTrial trial = plan_lamp_trial(context.scene, context.filter, options, is_over);
  if (trial.blocks == 0) return {};
  const std::uint64_t seed = seed_of(SeedStream::LampPixels, options.seed);
  const auto width = static_cast<std::uint32_t>(options.width);
  std::vector<LampCoverage> coverage(
      static_cast<std::size_t>(width) * static_cast<std::size_t>(options.height),
      LampCoverage::None);
  constexpr std::size_t at_once = 64;
  parallel_for((trial.views.size() + at_once - 1) / at_once, [&](std::size_t chunk) {
    if (is_over()) return;
    const std::size_t end = std::min((chunk + 1) * at_once, trial.views.size());
    for (std::size_t i = chunk * at_once; i < end; ++i) {
      const auto& [index, part] = trial.views[i];
      const std::uint32_t x = index % width;
      const std::uint32_t y = index / width;
      coverage[index] = lamp_coverage<F>(context, PixelSampler(seed, x, y, 1), part,
                                         static_cast<int>(x), static_cast<int>(y), trial.blocks);
    }
  });
  if (is_over()) return {};
  const PixelMask edges = lamp_edges(coverage, options.width, options.height);
  std::erase_if(trial.views, [&](const LampView& view) { return edges[view.index] == 0; });
  const std::uint32_t rays = affordable_lamp_rays(trial.views.size(), options);
  if (rays == 0) return {};
  return {std::move(trial.views), options.width, rays};
}

}  // namespace candela
