// Blocks of samples, bounce by bounce: the rays of each are traced together; paths on plain
// surfaces take their steps together whatever block they are of, the others one by one.
#pragma once

#include "integrators/path/block_lanes.h"
#include "integrators/path/block_trip.h"
#include "integrators/path/media_step.h"
#include "integrators/path/sky_lanes.h"
#include "integrators/path_observer.h"

namespace candela {

// Where the rays of the paths end. Of surfaces in the very same place a packet may meet another one
// than a single ray or a packet with other lanes does: which lanes there are follows from the
// picture's ranges of samples alone (shared_block.h), from no tile, crop or thread.
template <class A>
[[nodiscard]] inline HitBlock intersect_lanes(const A& accelerator, const RayBlock& rays,
                                              LaneMask lanes, std::uint32_t bounce) {
  return accelerator.intersect(rays, lanes, coherence_of(bounce));
}

template <FeatureSet F, class A>
[[nodiscard]] inline bool take_step(const PathContext<A>& context, const StepNumbers& numbers,
                                    std::uint32_t bounce, std::uint32_t i, const Hit& hit, Ray& ray,
                                    PathState& path, DirectLight& picked, PathBlock& block,
                                    TileCounts& counts) {
  if constexpr (F.media)
    return step_in_media<F>(context, numbers, bounce, hit, ray, block.media[i], path, picked,
                            block.shadow_media[i], block.alpha[i], block.first_hits[i], counts);
  else
    return step<F>(context, numbers, bounce, hit, ray, path, picked, block.first_hits[i], counts);
}

// The numbers of the path in a lane at this bounce.
template <FeatureSet F, class A>
[[nodiscard]] inline StepNumbers numbers_of(const BlockTrip<A>& trip, std::uint32_t i) {
  if (trip.is_drawn_together) return trip.numbers.template lane<F>(i);
  StepNumbers own;
  draw_hit<F>(trip.context.scene, trip.hit_samplers().lane(i), trip.bounce, own);
  draw_direction<F>(trip.context.scene, trip.context.roulette, trip.path_samplers().lane(i),
                    trip.bounce, own);
  return own;
}

// The same on a surface of a delta model.
template <FeatureSet F, class A>
[[nodiscard]] inline StepNumbers numbers_of_delta(const BlockTrip<A>& trip, std::uint32_t i) {
  if (trip.is_drawn_together) return trip.numbers.template lane<F>(i);
  StepNumbers own;
  draw_delta(trip.context.scene, trip.context.roulette, trip.path_samplers().lane(i), trip.bounce,
             own);
  return own;
}

// Lanes for which numbers are drawn side by side.
inline constexpr std::uint32_t fewest_drawn_together = 4;

template <FeatureSet F, class A>
inline void draw_numbers(BlockTrip<A>& trip) {
  trip.is_drawn_together = lane_count(trip.alive) >= fewest_drawn_together;
  if (!trip.is_drawn_together) return;
  trip.numbers.template draw_hit<F>(trip.context.scene, trip.hit_samplers(), trip.bounce);
  trip.numbers.template draw_direction<F>(trip.context.scene, trip.context.roulette,
                                          trip.path_samplers(), trip.bounce);
}

// A step of the path in lane i.
template <FeatureSet F, class A>
inline void step_lane(BlockTrip<A>& trip, std::uint32_t i) {
  const PathContext<A>& context = trip.context;
  PathBlock& block = trip.block;
  LanesAfterStep& after = trip.after;
  Ray ray = block.rays[i];
  PathState path = block.paths[i];
  DirectLight picked;
  bool goes_on = false;
  trip.count_for(i, [&] {
    goes_on = take_step<F>(context, numbers_of<F>(trip, i), trip.bounce, i, block.hits[i], ray,
                           path, picked, block, trip.counts);
  });
  if (!is_black(picked.contribution) && is_traceable(picked.shadow_ray)) {
    block.shadow_rays.set(i, picked.shadow_ray);
    block.unshadowed.set(i, picked.contribution);
    after.shadow_rays |= 1u << i;
    if (picked.lacks_sky) after.sky_rays |= 1u << i;
  }
  if constexpr (F.observed()) {
    if (context.observer != nullptr && goes_on)
      context.observer->leave(i, {.ray = ray,
                                  .receiving_normal = path.receiving_normal,
                                  .pdf = path.bsdf_pdf,
                                  .bsdf_pdf = path.bsdf_pdf / path.guide_ratio,
                                  .is_delta = path.is_delta,
                                  .throughput_before = block.paths.throughput[i],
                                  .roulette_throughput = path.roulette_throughput() * path.survival,
                                  .survival = path.survival});
  }
  block.paths.set(i, path);
  if (goes_on && set_ray(block, i, ray)) after.going_on |= 1u << i;
}

// Takes from `block.unshadowed` what stands in the shadow rays' way; returns the lanes in which
// something is left.
template <FeatureSet F, class A>
[[nodiscard]] inline LaneMask trace_shadow_rays(BlockTrip<A>& trip, LaneMask lanes) {
  const PathContext<A>& context = trip.context;
  PathBlock& block = trip.block;
  LaneMask arriving = 0;
  if (F.media && context.scene.features.clear_boundaries) {
    for_each_lane(lanes, [&](std::uint32_t i) {
      Rgb unshadowed = block.unshadowed[i];
      trip.count_for(i, [&] {
        unshadowed *= light_through_boundaries(context, block.shadow_rays[i], block.shadow_media[i],
                                               trip.counts);
      });
      block.unshadowed.set(i, unshadowed);
      if (!is_black(unshadowed)) arriving |= 1u << i;
    });
    return arriving;
  }
  arriving = lanes & ~context.accelerator.occluded(block.shadow_rays, lanes);
  if constexpr (F.media) {
    for_each_lane(arriving, [&](std::uint32_t i) {
      const Rgb transmittance = transmittance_of(optical_depth_along(
          context.scene, block.shadow_media[i], block.shadow_rays[i], block.shadow_rays.t_max[i]));
      block.unshadowed.set(i, block.unshadowed[i] * transmittance);
    });
  }
  trip.count_shadow_rays(lanes);
  return arriving;
}

// What the sky sends from the directions in the given lanes.
template <FeatureSet F>
inline void find_sky(const Scene& scene, LaneMask lanes, const Vec3Lanes& directions,
                     Coherence coherence, Vec3Lanes& radiance) {
  const Environment& sky = *scene.environment;
  if (F.lanes && lane_count(lanes) >= fewest_in_sky && !sky.is_constant())
    return find_sky_radiance(sky, scene.textures, lanes, directions, coherence, radiance);
  for_each_lane(lanes, [&](std::uint32_t i) {
    radiance.set(i, environment_radiance(sky, scene.textures, directions[i]));
  });
}

// Adds what the shadow rays bring that arrive.
template <FeatureSet F, class A>
inline void add_direct_light(const PathContext<A>& context, const LanesAfterStep& after,
                             PathBlock& block) {
  const LaneMask arriving = after.arriving;
  if (const LaneMask sky = arriving & after.sky_rays; sky != 0) {
    Vec3Lanes radiance;
    find_sky<F>(context.scene, sky, block.shadow_rays.direction, Coherence::Incoherent, radiance);
    for_each_lane(
        sky, [&](std::uint32_t i) { block.unshadowed.set(i, block.unshadowed[i] * radiance[i]); });
  }
  if (arriving != 0) add_unshadowed(arriving, block);
}

// Light from the sky that the paths in the given lanes end in.
template <FeatureSet F, class A>
inline void add_sky(const PathContext<A>& context, LaneMask lanes, Coherence coherence,
                    PathBlock& block) {
  static_assert(!(F.lanes && F.strategies));
  const Scene& scene = context.scene;
  const Vec3Lanes& directions = block.rays.direction;
  Vec3Lanes radiance;
  find_sky<F>(scene, lanes, directions, coherence, radiance);
  if (F.lanes && lane_count(lanes) >= fewest_in_sky)
    return add_met_sky(scene, lanes, directions, radiance, block.paths);
  for_each_lane(lanes, [&](std::uint32_t i) {
    PathState path = block.paths[i];
    add_environment<F>(scene, context.options, directions[i], radiance[i], path);
    block.paths.radiance.set(i, path.radiance);
  });
}

// Ends the paths whose rays left the scene; returns the others. (Within a medium a ray may collide
// before it leaves.)
template <FeatureSet F, class A>
[[nodiscard]] inline LaneMask end_in_environment(const PathContext<A>& context, LaneMask alive,
                                                 std::uint32_t bounce, const HitBlock& hits,
                                                 PathBlock& block) {
  const LaneMask ended = lanes_without_medium<F>(block, alive) & ~hits.met;
  if (bounce == 0) for_each_lane(ended, [&](std::uint32_t i) { block.alpha[i] = 0; });
  if (ended != 0 && sees_environment(context.scene, context.options, bounce))
    add_sky<F>(context, ended, coherence_of(bounce), block);
  return alive & ~ended;
}

// The rays of the paths that are alive have ended; so do the paths whose rays left the scene.
template <FeatureSet F, class A>
inline void meet(BlockTrip<A>& trip) {
  PathBlock& block = trip.block;
  if (trip.branches.is_split() && trip.bounce == 0) block.split.hits = block.hits;
  if constexpr (F.observed()) {
    if (trip.context.observer != nullptr)
      for_each_lane(trip.alive,
                    [&](std::uint32_t i) { trip.context.observer->meet(i, block.hits.t[i]); });
  }
  trip.alive = end_in_environment<F>(trip.context, trip.alive, trip.bounce, block.hits, block);
  trip.after = {};
  if (trip.alive != 0) draw_numbers<F>(trip);
}

// What the shadow rays bring, and on to the next bounce, or branch.
template <FeatureSet F, class A>
inline void go_on(BlockTrip<A>& trip, PlainLanes& lanes) {
  PathBlock& block = trip.block;
  if (trip.after.shadow_rays != 0) add_direct_light<F>(trip.context, trip.after, block);
  trip.alive = trip.after.going_on;
  if constexpr (F.observed()) {
    if (trip.context.observer != nullptr)
      for_each_lane(trip.alive, [&](std::uint32_t i) {
        trip.context.observer->radiance_so_far(i, block.paths.radiance[i]);
      });
  }
  Branches& branches = trip.branches;
  if (branches.is_split()) {
    if (trip.bounce == 0) branches.keep_direct_light(block);
    for (; trip.alive == 0 && branches.next(block); trip.bounce = 0)
      trip.alive = branches.template start<F>(trip.context, trip.samplers, block, lanes);
  }
  ++trip.bounce;
  trip.count_bounces(trip.alive);
}

}  // namespace candela
