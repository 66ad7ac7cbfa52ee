// Up to sixteen consecutive samples of a pixel, bounce by bounce: their rays are traced together,
// then each path takes its step.
#pragma once

#include "integrators/path/block_numbers.h"

namespace candela {

// The paths of a block on their way, by lane.
struct PathBlock {
  std::array<PathState, block_size> paths;
  std::array<DirectLight, block_size> picked;  // light whose shadow rays are still to be traced
  std::array<FilmSample, block_size> samples;
};

// Where the rays of the paths end. Only whole blocks are traced as packets: of surfaces in the very
// same place a packet may meet another one than a single ray, and so may a packet with other lanes.
template <class A>
inline void intersect_lanes(const A& accelerator, const PathBlock& block, LaneMask lanes,
                            std::uint32_t bounce, bool is_whole, HitBlock& hits) {
  constexpr int fewest_of_packet = 4;
  if (!is_whole || std::popcount(lanes) < fewest_of_packet) {
    for_each_lane(lanes,
                  [&](std::uint32_t i) { hits[i] = accelerator.intersect(block.paths[i].ray); });
    return;
  }
  RayBlock rays;
  for_each_lane(lanes, [&](std::uint32_t i) { rays[i] = block.paths[i].ray; });
  hits =
      accelerator.intersect(rays, lanes, bounce == 0 ? Coherence::Coherent : Coherence::Incoherent);
}

// The light that was picked, where nothing shades it.
template <class A>
inline void add_picked_light(const A& accelerator, LaneMask lanes, PathBlock& block,
                             TileCounts& counts) {
  LaneMask asked = 0;
  RayBlock rays;
  for_each_lane(lanes, [&](std::uint32_t i) {
    const DirectLight& light = block.picked[i];
    if (is_black(light.contribution) || !is_traceable(light.shadow_ray)) return;
    rays[i] = light.shadow_ray;
    asked |= 1u << i;
  });
  if (asked == 0) return;
  counts.rays.shadow += static_cast<std::uint64_t>(std::popcount(asked));
  const LaneMask lit = asked & ~accelerator.occluded(rays, asked);
  for_each_lane(lit,
                [&](std::uint32_t i) { block.paths[i].radiance += block.picked[i].contribution; });
}

// Lanes whose next ray can be traced. The others end as invalid samples.
inline LaneMask traceable_lanes(LaneMask lanes, PathBlock& block) {
  LaneMask traceable = 0;
  for_each_lane(lanes, [&](std::uint32_t i) {
    if (is_traceable(block.paths[i].ray))
      traceable |= 1u << i;
    else
      block.paths[i].radiance = Rgb(std::numeric_limits<float>::quiet_NaN());
  });
  return traceable;
}

// From camera rays in `block.paths` to radiances in `block.samples`.
template <FeatureSet F, class A>
inline void trace_block(const PathContext<A>& context, const SamplerBlock& samplers, LaneMask lanes,
                        PathBlock& block, TileCounts& counts) {
  const bool is_whole = lanes == all_lanes;
  counts.rays.camera += static_cast<std::uint64_t>(std::popcount(lanes));
  HitBlock hits;
  BlockNumbers numbers;
  LaneMask alive = lanes;
  for (std::uint32_t bounce = 0;; ++bounce) {
    alive = traceable_lanes(alive, block);
    if (alive == 0) break;
    intersect_lanes(context.accelerator, block, alive, bounce, is_whole, hits);
    constexpr int fewest_of_vectors = 4;
    const bool is_drawn_together = std::popcount(alive) >= fewest_of_vectors;
    if (is_drawn_together) numbers.draw<F>(context.scene, samplers, bounce);
    LaneMask going_on = 0;
    for_each_lane(alive, [&](std::uint32_t i) {
      StepNumbers own = is_drawn_together ? numbers.lane(i)
                                          : numbers_of<F>(context.scene, samplers.lane(i), bounce);
      block.picked[i].contribution = Rgb(0);
      if (step<F>(context, own, bounce, hits[i], block.paths[i], block.picked[i], block.samples[i],
                  counts))
        going_on |= 1u << i;
    });
    add_picked_light(context.accelerator, alive, block, counts);
    counts.rays.indirect += static_cast<std::uint64_t>(std::popcount(going_on));
    alive = going_on;
  }
  for_each_lane(lanes,
                [&](std::uint32_t i) { block.samples[i].radiance = block.paths[i].radiance; });
}

}  // namespace candela
