// Up to sixteen consecutive samples of a pixel, bounce by bounce: their rays are traced together,
// then each path takes its step.
#pragma once

#include "integrators/path/block_numbers.h"

namespace candela {

// The paths of a block on their way, by lane.
struct PathBlock {
  RayBlock rays;
  std::array<PathState, block_size> paths;
  RayBlock shadow_rays;
  std::array<Rgb, block_size> unshadowed;  // what the shadow rays bring if nothing is in their way
  std::array<FilmSample, block_size> samples;
};

// The next ray of a path; false where it cannot be traced, which makes the sample invalid.
[[nodiscard]] inline bool set_ray(PathBlock& block, std::uint32_t i, const Ray& ray) {
  block.rays[i] = ray;
  if (is_traceable(ray)) return true;
  block.paths[i].radiance = Rgb(std::numeric_limits<float>::quiet_NaN());
  return false;
}

// Where the rays of the paths end. Only whole blocks are traced as packets: of surfaces in the very
// same place a packet may meet another one than a single ray, and so may a packet with other lanes.
template <class A>
[[nodiscard]] inline HitBlock intersect_lanes(const A& accelerator, const RayBlock& rays,
                                              LaneMask lanes, std::uint32_t bounce, bool is_whole) {
  constexpr int fewest_of_packet = 4;
  if (!is_whole || std::popcount(lanes) < fewest_of_packet)
    return intersect_one_by_one(accelerator, rays, lanes);
  return accelerator.intersect(rays, lanes,
                               bounce == 0 ? Coherence::Coherent : Coherence::Incoherent);
}

// Which lanes of a block have a shadow ray, and which a ray to go on with.
struct LanesAfterStep {
  LaneMask shadow_rays = 0;
  LaneMask going_on = 0;
};

// A step of the path in lane i.
template <FeatureSet F, class A>
inline void step_lane(const PathContext<A>& context, const StepNumbers& numbers,
                      std::uint32_t bounce, std::uint32_t i, const Hit& hit, PathBlock& block,
                      LanesAfterStep& after, TileCounts& counts) {
  Ray ray = block.rays[i];
  PathState path = block.paths[i];
  DirectLight picked;
  const bool goes_on =
      step<F>(context, numbers, bounce, hit, ray, path, picked, block.samples[i], counts);
  if (!is_black(picked.contribution) && is_traceable(picked.shadow_ray)) {
    block.shadow_rays[i] = picked.shadow_ray;
    block.unshadowed[i] = picked.contribution;
    after.shadow_rays |= 1u << i;
  }
  block.paths[i] = path;
  if (goes_on && set_ray(block, i, ray)) after.going_on |= 1u << i;
}

// Steps of all paths that are alive.
template <FeatureSet F, class A>
[[nodiscard]] inline LanesAfterStep step_lanes(const PathContext<A>& context,
                                               const SamplerBlock& samplers, LaneMask alive,
                                               std::uint32_t bounce, const HitBlock& hits,
                                               PathBlock& block, TileCounts& counts) {
  constexpr int fewest_of_vectors = 4;
  const bool is_drawn_together = std::popcount(alive) >= fewest_of_vectors;
  BlockNumbers numbers;
  if (is_drawn_together) numbers.draw<F>(context.scene, samplers, bounce);
  LanesAfterStep after;
  for_each_lane(alive, [&](std::uint32_t i) {
    StepNumbers own = is_drawn_together ? numbers.lane(i)
                                        : numbers_of<F>(context.scene, samplers.lane(i), bounce);
    step_lane<F>(context, own, bounce, i, hits[i], block, after, counts);
  });
  return after;
}

// From the camera rays in `block.rays` of the lanes that are alive to the paths' radiances.
template <FeatureSet F, class A>
inline void trace_block(const PathContext<A>& context, const SamplerBlock& samplers, LaneMask alive,
                        bool is_whole, PathBlock& block, TileCounts& counts) {
  const A& accelerator = context.accelerator;
  for (std::uint32_t bounce = 0; alive != 0; ++bounce) {
    const HitBlock hits = intersect_lanes(accelerator, block.rays, alive, bounce, is_whole);
    const LanesAfterStep after =
        step_lanes<F>(context, samplers, alive, bounce, hits, block, counts);
    if (after.shadow_rays != 0) {
      const LaneMask shaded = accelerator.occluded(block.shadow_rays, after.shadow_rays);
      for_each_lane(after.shadow_rays & ~shaded,
                    [&](std::uint32_t i) { block.paths[i].radiance += block.unshadowed[i]; });
    }
    counts.rays.shadow += static_cast<std::uint64_t>(std::popcount(after.shadow_rays));
    counts.rays.indirect += static_cast<std::uint64_t>(std::popcount(after.going_on));
    alive = after.going_on;
  }
}

}  // namespace candela
