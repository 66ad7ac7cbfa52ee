// Which pixels are to have more camera rays for lamps, and how many, before any sample is drawn.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "integrators/lamp_pixels.h"
#include "integrators/path/seen_lamps.h"
#include "integrators/pixel_cover.h"
#include "integrators/seed_stream.h"

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
    const LaneMask traced =
        aim_at_lamps(context, samplers, part, place.pixels, place.lanes, rays).traced;
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
  std::optional<LampViews> outlines;  // none: they would take long
  CoveredPixels pixels;               // without outlines: the whole of each
  std::uint32_t blocks = 0;

  // In a part of a picture of that width, by index.
  [[nodiscard]] std::vector<LampView> views(const PixelRect& rect, int width) const;
};
[[nodiscard]] LampTrial plan_lamp_trial(const Scene& scene, const Filter& filter,
                                        const RenderOptions& options);

// Pixels, in rows of `width`, that are not covered like all of their neighbours: what the trial
// missed of a lamp's edge lies beside what it found.
[[nodiscard]] std::vector<std::uint8_t> lamp_edges(const std::vector<LampCoverage>& coverage,
                                                   int width, int height);

// The most rays a sample of so many pixels that take at most an eighth or so of the picture's time,
// by twos; 0: more than one would take longer.
[[nodiscard]] std::uint32_t affordable_lamp_rays(double pixels, const RenderOptions& options);

// How many there are: of more than a thousand patches (four million pixels) a thousand tell,
// whatever the crop. None where `is_over`, asked between patches, says so.
[[nodiscard]] std::optional<double> count_lamp_pixels(const LampPixels& pixels, std::uint64_t seed,
                                                      const std::function<bool()>& is_over);

// A rectangle and the pixels around it.
[[nodiscard]] PixelRect with_neighbours(const PixelRect& rect, const RenderOptions& options);

// Lamps' edges in a part of the picture.
template <FeatureSet F, class A>
[[nodiscard]] std::vector<LampView> lamp_edges_in(const PathContext<A>& context,
                                                  const LampTrial& trial, const PixelRect& rect,
                                                  std::uint64_t seed) {
  const int width = context.options.width;
  const PixelRect around = with_neighbours(rect, context.options);
  std::vector<LampView> views = trial.views(around, width);
  if (views.empty()) return {};
  const auto x_of = [&](const LampView& view) {
    return static_cast<int>(view.index % static_cast<std::uint32_t>(width));
  };
  const auto y_of = [&](const LampView& view) {
    return static_cast<int>(view.index / static_cast<std::uint32_t>(width));
  };
  const auto place = [&](const LampView& view) { return around.index(x_of(view), y_of(view)); };
  std::vector<LampCoverage> coverage(
      static_cast<std::size_t>(around.width()) * static_cast<std::size_t>(around.height()),
      LampCoverage::None);
  for (const LampView& view : views) {
    const int x = x_of(view);
    const int y = y_of(view);
    const PixelSampler pixel(seed, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 1);
    coverage[place(view)] = lamp_coverage<F>(context, pixel, view.part, x, y, trial.blocks);
  }
  const std::vector<std::uint8_t> edges = lamp_edges(coverage, around.width(), around.height());
  std::erase_if(views, [&](const LampView& view) {
    return !rect.contains(x_of(view), y_of(view)) || edges[place(view)] == 0;
  });
  return views;
}

// Of the whole picture, by random numbers of its own: the same for any crop and threads. None in
// scenes with media, or where finding out would take long. `is_over`: asked now and then whether to
// give up; then none, too. What the context refers to must outlive them.
template <FeatureSet F, class A>
[[nodiscard]] LampPixels find_lamp_pixels(const PathContext<A>& context,
                                          const std::function<bool()>& is_over) {
  const RenderOptions& options = context.options;
  const std::uint64_t seed = seed_of(SeedStream::LampPixels, options.seed);
  auto trial =
      std::make_shared<const LampTrial>(plan_lamp_trial(context.scene, context.filter, options));
  if (trial->blocks == 0) return {};
  LampPixels pixels(options.width, options.height, [context, trial, seed](const PixelRect& patch) {
    return lamp_edges_in<F>(context, *trial, patch, seed);
  });
  const std::optional<double> count = count_lamp_pixels(pixels, seed, is_over);
  const std::uint32_t rays = count ? affordable_lamp_rays(*count, options) : 0;
  if (rays == 0) return {};
  pixels.set_rays_a_sample(rays);
  return pixels;
}

}  // namespace candela
