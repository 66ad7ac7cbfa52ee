// What lamps send straight to the camera, by rays that look for nothing else (lamp_pixels.h).
#pragma once

#include <limits>

#include "integrators/lamp_pixels.h"
#include "integrators/path/camera_rays.h"
#include "integrators/path/trace_block.h"
#include "integrators/tile_counts.h"

namespace candela {

template <class A>
[[nodiscard]] inline const LampView* lamp_view(const PathContext<A>& context, int x, int y) {
  return context.lamps != nullptr ? context.lamps->find(x, y) : nullptr;
}
template <class A>
[[nodiscard]] inline bool has_lamp_rays(const PathContext<A>& context, int x, int y) {
  return lamp_view(context, x, y) != nullptr;
}

// The context of a pixel's own blocks.
template <class A>
[[nodiscard]] inline PathContext<A> context_at(const PathContext<A>& context, int x, int y) {
  PathContext<A> here = context;
  if (const LampView* view = lamp_view(context, x, y)) {
    here.lamp_rays = context.lamps->rays_a_sample();
    here.lamp_part = view->part;
  }
  return here;
}

struct AimedRays {
  PlaceLanes places;
  LaneMask traced;  // those that can be
};

// Rays through places in a part of the pixel, by numbers that no path's camera ray takes.
template <class A>
[[nodiscard]] inline AimedRays aim_at_lamps(const PathContext<A>& context,
                                            const SamplerBlock& samplers, const FilterPart& part,
                                            const PixelLanes& pixels, LaneMask lanes,
                                            RayBlock& rays) {
  CameraNumbers numbers;
  numbers.draw(context.camera, samplers, Dimension::LampFilter, Dimension::LampLens);
  const PlaceLanes places = sample_places(context.filter, part, numbers);
  return {places, aim_camera_rays(context.camera, pixels, places, numbers, lanes, rays)};
}

// Radiance along a camera ray, of the surface that it met itself.
template <FeatureSet F>
[[nodiscard]] inline Rgb lamp_radiance(const Scene& scene, const RenderOptions& options,
                                       const Ray& ray, const Hit& hit) {
  if (!hit.is_hit()) return Rgb(0);
  const Geometry& geometry = scene.geometries[hit.geometry];
  if (!geometry.is_emissive()) return Rgb(0);
  PathState path;
  add_emission<F>(scene, options, geometry, hit, ray.origin, ray.direction, hit.t, path);
  return path.radiance;
}

// Whether what each ray brings has a weight or a clamp of its own.
[[nodiscard]] inline bool are_lamps_apart(const Filter& filter, float clamp) {
  return filter.is_signed() || clamp < std::numeric_limits<float>::infinity();
}

// To each sample of a block, which is of one pixel, the mean over its rays, times the part's share:
// to its path's radiance, or apart from it. Out of line: few pixels have any.
template <FeatureSet F, class A>
[[gnu::noinline]] void add_seen_lamps(BlockTrip<A>& trip) {
  const PathContext<A>& context = trip.context;
  const std::uint32_t count = context.lamp_rays;
  const float share = context.lamp_part.share() / static_cast<float>(count);
  const float clamp = context.options.clamp;
  if (are_lamps_apart(context.filter, clamp)) trip.weighted_lamps.emplace();
  Vec3Lanes& sums = trip.weighted_lamps ? *trip.weighted_lamps : trip.block.paths.radiance;
  RayBlock rays;
  for (std::uint32_t k = 0; k < count; ++k) {
    const SamplerBlock samplers(*trip.pixel, trip.place.samples[0], count, k);
    const AimedRays aimed = aim_at_lamps(context, samplers, context.lamp_part, trip.place.pixels,
                                         trip.place.lanes, rays);
    for_each_lane(trip.place.lanes & ~aimed.traced,
                  [&](std::uint32_t i) { lose_path(trip.block, i); });
    const HitBlock hits = intersect_lanes(context.accelerator, rays, aimed.traced, 0);
    for_each_lane(aimed.traced, [&](std::uint32_t i) {
      const Rgb lamp = lamp_radiance<F>(context.scene, context.options, rays[i], hits[i]);
      const float weight = context.filter.weight(aimed.places[i]);
      sums.set(i, sums[i] + weight * (share * dimmed(lamp, clamp)));
    });
    trip.counts.rays.lamp += lane_count(aimed.traced);
  }
}

}  // namespace candela
