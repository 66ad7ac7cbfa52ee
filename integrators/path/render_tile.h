// A tile's pixels through the path kernel: camera rays in, film samples out.
#pragma once

#include "integrators/background_pixels.h"
#include "integrators/lamp_pixels.h"
#include "integrators/path/convoy.h"
#include "integrators/path/seen_lamps.h"
#include "integrators/tile_pass.h"

namespace candela {

// The paths of a block start at the camera.
template <FeatureSet F, class A>
inline void start(BlockTrip<A>& trip) {
  const PathContext<A>& context = trip.context;
  PathBlock& block = trip.block;
  CameraNumbers numbers;
  numbers.draw(context.camera, trip.samplers, Dimension::Filter, Dimension::Lens);
  const PlaceLanes places = sample_places(context.filter, {}, numbers);
  trip.alive = aim_camera_rays(context.camera, cell_of(context, trip.place.x, trip.place.y), places,
                               numbers, trip.place.lanes, block.rays);
  begin_paths(block.paths);
  if constexpr (F.media) block.media.fill(context.camera.medium);
  block.alpha.fill(1);
  for (std::uint32_t i = 0; i < block_size; ++i) block.weight[i] = context.filter.weight(places[i]);
  if (context.options.aovs != 0) block.first_hits.fill({});
  for_each_lane(trip.place.lanes & ~trip.alive, [&](std::uint32_t i) { lose_path(block, i); });
  trip.counts.rays.camera += lane_count(trip.place.lanes);
}

// The paths of a block have ended.
template <FeatureSet F, class A>
inline void finish(BlockTrip<A>& trip, Film& film, TileCounts& counts) {
  const PathContext<A>& context = trip.context;
  PathBlock& block = trip.block;
  if constexpr (F.guided) {
    if (context.training != nullptr)
      for_each_lane(trip.place.lanes,
                    [&](std::uint32_t i) { context.training->end(i, block.paths.radiance[i]); });
  }
  if (context.lamp_rays > 0) add_seen_lamps<F>(trip);
  FilmSample bare;
  for_each_lane(trip.place.lanes, [&](std::uint32_t i) {
    FilmSample& sample = context.options.aovs != 0 ? block.first_hits[i] : bare;
    sample.radiance = block.paths.radiance[i];
    sample.weight = block.weight[i];
    sample.alpha = block.alpha[i];
    add_or_count(sample, trip.place.x, trip.place.y, trip.place.first + i, context.options.clamp,
                 film, trip.counts);
  });
  film.add_cost(trip.place.x, trip.place.y, static_cast<std::uint32_t>(cost_of(trip.counts.rays)));
  counts.add(trip.counts);
}

template <FeatureSet F, class A>
inline void travel(Convoy<F, A>& convoy, Film& film, TileCounts& counts) {
  convoy.travel();
  convoy.for_each_trip([&](BlockTrip<A>& trip) { finish<F>(trip, film, counts); });
  convoy.clear();
}

// Lanes of the block at `base` whose samples lie in the range, which ends after `base`.
[[nodiscard]] inline LaneMask lanes_in(std::uint32_t base, const SampleRange& range) {
  const LaneMask from_first = range.first > base ? all_lanes << (range.first - base) : all_lanes;
  const LaneMask to_end =
      range.end - base < block_size ? (1u << (range.end - base)) - 1 : all_lanes;
  return from_first & to_end & all_lanes;
}

// How many independent sequences the samples of a pixel are dealt to: one a replicate, or one each.
[[nodiscard]] inline std::uint32_t sequences_of(const RenderOptions& options, const Film& film) {
  return options.sampler == SamplerKind::Independent ? std::numeric_limits<std::uint32_t>::max()
                                                     : film.replicates();
}

[[nodiscard]] inline PairOrder pair_order_of(const RenderOptions& options) {
  return options.sampler == SamplerKind::Padded ? PairOrder::Padded : PairOrder::Joint;
}

// What the samples of a pixel that sees nothing would have brought and, in rays, taken.
inline void add_background(const BackgroundPixels& background, const SampleRange& range, int x,
                           int y, float clamp, Film& film, TileCounts& counts) {
  for (std::uint32_t i = range.first; i < range.end; ++i)
    add_or_count(background.sample(), x, y, i, clamp, film, counts);
  const std::uint32_t count = range.end - range.first;
  film.add_cost(x, y, static_cast<std::uint32_t>(cost_of({.camera = count})));
  counts.skipped.samples += count;
}

struct NoTrainingLog {};
template <FeatureSet F>
using TrainingLogOf = std::conditional_t<F.guided, TrainingLog, NoTrainingLog>;

// The samples of a pass, in order.
template <FeatureSet F, class A>
TileCounts render_tile(const PathContext<A>& of_render, const TilePass& pass, Film& film) {
  PathContext<A> context = of_render;
  context.inverse_roulette_threshold = 1 / pass.plan.roulette_threshold;
  context.guide = pass.guide;
  TrainingLogOf<F> training;
  if constexpr (F.guided) {
    if (pass.training != nullptr) context.training = &training;
  }
  const PixelRect& tile = pass.tile;
  const std::uint32_t splitting = F.media && context.scene.features.media ? 1 : pass.plan.splitting;
  TileCounts counts;
  Convoy<F, A> convoy;
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      const SampleRange range = pass.of_pixel(x, y);
      if (context.background != nullptr && context.background->contains(x, y)) {
        add_background(*context.background, range, x, y, context.options.clamp, film, counts);
        continue;
      }
      const PixelSampler pixel(pass.seed, static_cast<std::uint32_t>(x),
                               static_cast<std::uint32_t>(y), sequences_of(context.options, film),
                               pair_order_of(context.options));
      aim_lamp_rays(x, y, context);
      for (std::uint32_t base = range.first & ~(block_size - 1); base < range.end;
           base += block_size) {
        start<F>(
            convoy.add(context, pixel, BlockPlace{x, y, base, lanes_in(base, range)}, splitting));
        if (convoy.is_full()) travel(convoy, film, counts);
      }
    }
  }
  travel(convoy, film, counts);
  if constexpr (F.guided) {
    if (pass.training != nullptr) *pass.training = std::move(training.records());
  }
  return counts;
}

}  // namespace candela
