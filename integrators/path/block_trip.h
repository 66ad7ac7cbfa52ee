// Up to sixteen samples on their way from the camera, of one pixel or of several: their rays are
// traced together, then each path takes its step.
#pragma once

#include "integrators/path/block_place.h"
#include "integrators/path/branches.h"

namespace candela {

template <class A>
struct BlockTrip {
  // Of one pixel.
  BlockTrip(const PathContext<A>& context_there, const BlockPlace& where,
            const PixelSampler& sampler_there, std::uint32_t splitting, PathBlock& paths)
      : context(context_there),
        pixel(sampler_there),
        place(where),
        samplers(*pixel, place.samples[0]),
        branches(*pixel, place.samples[0], splitting),
        block(paths) {}
  // Of several.
  BlockTrip(const PathContext<A>& context_there, const BlockPlace& where,
            const SamplerBlock& samplers_there, PathBlock& paths)
      : context(context_there), place(where), samplers(samplers_there), block(paths) {}
  BlockTrip(const BlockTrip&) = delete;  // branches refer to its pixel
  BlockTrip& operator=(const BlockTrip&) = delete;

  [[nodiscard]] bool is_of_one_pixel() const { return pixel.has_value(); }

  // A ray of each of the lanes.
  void count_bounces(LaneMask lanes) {
    counts.rays.indirect += lane_count(lanes);
    add_cost(lanes, cost_of({.indirect = 1}));
  }
  void count_shadow_rays(LaneMask lanes) {
    counts.rays.shadow += lane_count(lanes);
    add_cost(lanes, cost_of({.shadow = 1}));
  }
  void count_segments(LaneMask lanes) {
    counts.rays.segment += lane_count(lanes);
    add_cost(lanes, cost_of({.segment = 1}));
  }
  // Calls count(), which counts rays of the lane.
  template <class Count>
  void count_for(std::uint32_t lane, const Count& count) {
    const std::uint64_t before = cost_of(counts.rays);
    count();
    costs[lane] += static_cast<std::uint32_t>(cost_of(counts.rays) - before);
  }

  // Of the paths that go on from the hits, and of the hits themselves.
  [[nodiscard]] const SamplerBlock& path_samplers() const { return branches.samplers(samplers); }
  [[nodiscard]] const SamplerBlock& hit_samplers() const {
    return bounce == 0 ? samplers : path_samplers();
  }

  const PathContext<A> context;             // as it is at the pixel
  const std::optional<PixelSampler> pixel;  // none where there are several
  const BlockPlace place;
  const SamplerBlock samplers;
  Branches branches;
  PathBlock& block;

  std::uint32_t bounce = 0;
  LaneMask alive = 0;  // paths that are on their way
  LanesAfterStep after;
  BlockNumbers numbers;
  bool is_drawn_together = false;  // `numbers` holds those of the bounce
  TileCounts counts;
  Lanes<std::uint32_t> costs{};  // of the lanes' rays, where they are of several pixels
  // What lamps' own rays brought, times the filter's weights, where it is not the paths' radiance.
  std::optional<Vec3Lanes> weighted_lamps;

 private:
  void add_cost(LaneMask lanes, std::uint64_t cost) {
    if (is_of_one_pixel()) return;
    for_each_lane(lanes, [&](std::uint32_t i) { costs[i] += static_cast<std::uint32_t>(cost); });
  }
};

}  // namespace candela
