// Up to sixteen consecutive samples of a pixel, bounce by bounce: their rays are traced together,
// then each path takes its step.
#pragma once

#include "integrators/guiding/training_log.h"
#include "integrators/path/branches.h"
#include "integrators/path/media_step.h"
#include "integrators/path/step_flat_lanes.h"

namespace candela {

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

template <FeatureSet F, class A>
[[nodiscard]] inline bool take_step(const PathContext<A>& context, const StepNumbers& numbers,
                                    std::uint32_t bounce, std::uint32_t i, const Hit& hit, Ray& ray,
                                    PathState& path, DirectLight& picked, PathBlock& block,
                                    TileCounts& counts) {
  if constexpr (F.media)
    return step_in_media<F>(context, numbers, bounce, hit, ray, block.media[i], path, picked,
                            block.shadow_media[i], block.samples[i], counts);
  else
    return step<F>(context, numbers, bounce, hit, ray, path, picked, block.samples[i], counts);
}

// A step of the path in lane i.
template <FeatureSet F, class A>
inline void step_lane(const PathContext<A>& context, const StepNumbers& numbers,
                      std::uint32_t bounce, std::uint32_t i, const Hit& hit, PathBlock& block,
                      LanesAfterStep& after, TileCounts& counts) {
  Ray ray = block.rays[i];
  PathState path = block.paths[i];
  DirectLight picked;
  const bool goes_on =
      take_step<F>(context, numbers, bounce, i, hit, ray, path, picked, block, counts);
  if (!is_black(picked.contribution) && is_traceable(picked.shadow_ray)) {
    block.shadow_rays[i] = picked.shadow_ray;
    block.unshadowed[i] = picked.contribution;
    after.shadow_rays |= 1u << i;
    if (F.environment && picked.lacks_sky) after.sky_rays |= 1u << i;
  }
  if constexpr (F.guided) {
    if (context.training != nullptr && goes_on && !path.is_delta)
      context.training->leave(i, ray, path.receiving_normal, path.bsdf_pdf,
                              path.bsdf_pdf * block.paths[i].roulette_scale / path.roulette_scale,
                              block.paths[i].throughput);
  }
  block.paths[i] = path;
  if (goes_on && set_ray(block, i, ray)) after.going_on |= 1u << i;
}

// The numbers of a bounce: of the hits themselves, and of the paths that go on from there.
struct BounceSamplers {
  const SamplerBlock& hit;
  const SamplerBlock& path;
};

// Steps of all paths that are alive.
template <FeatureSet F, class A>
[[nodiscard]] inline LanesAfterStep step_lanes(const PathContext<A>& context,
                                               const BounceSamplers& samplers, LaneMask alive,
                                               std::uint32_t bounce, const HitBlock& hits,
                                               PathBlock& block, TileCounts& counts) {
  const bool is_drawn_together = std::popcount(alive) >= fewest_of_vectors;
  BlockNumbers numbers;
  if (is_drawn_together) {
    numbers.draw_hit<F>(context.scene, samplers.hit, bounce);
    numbers.draw_direction<F>(context.scene, samplers.path, bounce);
  }
  LanesAfterStep after;
  if constexpr (has_flat_lanes<F>) {
    if (is_drawn_together) {
      const FlatMasks flat = flat_lanes_of(context.scene, hits, alive);
      if (flat.all() != 0)
        step_flat_lanes<F>(context, numbers, bounce, flat, hits, block, after, counts);
      alive &= ~flat.all();
    }
  }
  for_each_lane(alive, [&](std::uint32_t i) {
    StepNumbers own;
    if (is_drawn_together) {
      own = numbers.lane<F>(i);
    } else {
      draw_hit<F>(context.scene, samplers.hit.lane(i), bounce, own);
      draw_direction<F>(context.scene, samplers.path.lane(i), bounce, own);
    }
    step_lane<F>(context, own, bounce, i, hits[i], block, after, counts);
  });
  return after;
}

// Takes from `block.unshadowed` what stands in the shadow rays' way; returns the lanes in which
// something is left.
template <FeatureSet F, class A>
[[nodiscard]] inline LaneMask trace_shadow_rays(const PathContext<A>& context, LaneMask lanes,
                                                PathBlock& block, TileCounts& counts) {
  LaneMask arriving = 0;
  if (F.media && context.scene.features.clear_boundaries) {
    for_each_lane(lanes, [&](std::uint32_t i) {
      block.unshadowed[i] *=
          light_through_boundaries(context, block.shadow_rays[i], block.shadow_media[i], counts);
      if (!is_black(block.unshadowed[i])) arriving |= 1u << i;
    });
    return arriving;
  }
  arriving = lanes & ~context.accelerator.occluded(block.shadow_rays, lanes);
  if constexpr (F.media) {
    for_each_lane(arriving, [&](std::uint32_t i) {
      block.unshadowed[i] *= transmittance_of(optical_depth_along(
          context.scene, block.shadow_media[i], block.shadow_rays[i], block.shadow_rays[i].t_max));
    });
  }
  counts.rays.shadow += static_cast<std::uint64_t>(std::popcount(lanes));
  return arriving;
}

// Adds what the shadow rays bring. Skies are looked up one right after the other, as below.
template <FeatureSet F, class A>
inline void add_direct_light(const PathContext<A>& context, const LanesAfterStep& after,
                             PathBlock& block, TileCounts& counts) {
  const LaneMask arriving = trace_shadow_rays<F>(context, after.shadow_rays, block, counts);
  if constexpr (F.environment) {
    for_each_lane(arriving & after.sky_rays, [&](std::uint32_t i) {
      block.unshadowed[i] *= environment_radiance(
          *context.scene.environment, context.scene.textures, block.shadow_rays[i].direction);
    });
  }
  for_each_lane(arriving, [&](std::uint32_t i) { block.paths[i].radiance += block.unshadowed[i]; });
}

// Ends the paths whose rays left the scene, one right after the other, so that their waits for the
// sky's texels overlap; returns the others. (Among media a ray may collide before it leaves.)
template <FeatureSet F, class A>
[[nodiscard]] inline LaneMask end_in_environment(const PathContext<A>& context, LaneMask alive,
                                                 std::uint32_t bounce, const HitBlock& hits,
                                                 PathBlock& block) {
  if constexpr (F.media) return alive;
  LaneMask ended = 0;
  for_each_lane(alive, [&](std::uint32_t i) { ended |= hits[i].is_hit() ? 0 : 1u << i; });
  for_each_lane(ended, [&](std::uint32_t i) {
    add_environment<F>(context.scene, context.options, bounce, block.rays[i].direction,
                       block.paths[i]);
    if (bounce == 0) block.samples[i].alpha = 0;
  });
  return alive & ~ended;
}

// A bounce of the paths of a block; returns those that go on.
template <FeatureSet F, class A>
[[nodiscard]] inline LaneMask leave_hits(const PathContext<A>& context,
                                         const BounceSamplers& samplers, LaneMask alive,
                                         std::uint32_t bounce, const HitBlock& hits,
                                         PathBlock& block, TileCounts& counts) {
  if constexpr (F.guided) {
    if (context.training != nullptr)
      for_each_lane(alive, [&](std::uint32_t i) { context.training->meet(i, hits[i].t); });
  }
  alive = end_in_environment<F>(context, alive, bounce, hits, block);
  if (alive == 0) return 0;
  const LanesAfterStep after = step_lanes<F>(context, samplers, alive, bounce, hits, block, counts);
  if (after.shadow_rays != 0) add_direct_light<F>(context, after, block, counts);
  if constexpr (F.guided) {
    if (context.training != nullptr)
      for_each_lane(after.going_on,
                    [&](std::uint32_t i) { context.training->had(i, block.paths[i].radiance); });
  }
  return after.going_on;
}

// From the camera rays in `block.rays` of the lanes that are alive to the paths' radiances.
template <FeatureSet F, class A>
inline void trace_block(const PathContext<A>& context, const SamplerBlock& samplers,
                        Branches branches, LaneMask alive, bool is_whole, PathBlock& block,
                        TileCounts& counts) {
  if (branches.is_split()) branches.begin(alive, block);
  for (std::uint32_t bounce = 0; alive != 0; ++bounce) {
    const HitBlock hits = intersect_lanes(context.accelerator, block.rays, alive, bounce, is_whole);
    const BounceSamplers own{bounce == 0 ? samplers : branches.samplers(samplers),
                             branches.samplers(samplers)};
    if (branches.is_split() && bounce == 0) block.split.hits = hits;
    alive = leave_hits<F>(context, own, alive, bounce, hits, block, counts);
    if (branches.is_split()) {
      if (bounce == 0) branches.keep_direct_light(block);
      for (; alive == 0 && branches.next(block); bounce = 0)
        alive = branches.start<F>(context, samplers, block);
    }
    counts.rays.indirect += static_cast<std::uint64_t>(std::popcount(alive));
  }
  if (branches.is_split()) branches.end(block);
}

}  // namespace candela
