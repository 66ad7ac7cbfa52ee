// What media, and surfaces that only bound them, leave of light along a shadow ray.
#pragma once

#include "integrators/path/context.h"
#include "integrators/path/media_beside.h"
#include "renderer/accel/accelerator.h"
#include "renderer/geometry/surface_point.h"
#include "renderer/light/shadow_segment.h"
#include "renderer/scene/met_point.h"

namespace candela {

// More boundaries than this a ray does not cross: what lies behind them is black.
inline constexpr int most_boundaries = 4096;

// Whether a hit only bounds media.
[[nodiscard]] inline bool is_clear_boundary(const Scene& scene, const Hit& hit) {
  if (!scene.features.clear_boundaries) return false;
  const MaterialHandle material = scene.geometries[hit.geometry].material;
  return scene.medium_boundaries[material.index].is_clear;
}

// The medium behind a surface that only bounds media.
[[nodiscard]] inline MediumHandle medium_beyond(const Scene& scene, const Hit& hit,
                                                const SurfacePoint& met, MediumHandle current) {
  const MaterialHandle material = scene.geometries[hit.geometry].material;
  return media_beside(scene.medium_boundaries[material.index], met.is_front, current).far;
}

// Where a ray that meets a surface at `t` leaves the medium before it: as far from the surface as
// rays start that come in (offset_origin()). Media begin and end there, so that light pays on its
// way out for no more than where it may have collided on its way in: dense ones would be dark else.
[[nodiscard]] inline float end_in_medium(float t, const SurfacePoint& met, const Vec3f& direction) {
  const float steepness = std::abs(dot(met.geometric_normal, direction));
  return steepness > 0 ? std::max(t - met.offset / steepness, 0.0f) : 0;
}

// Optical depth of a part of a ray; `end` in units of its direction's length, infinity beyond all.
[[nodiscard]] inline Rgb optical_depth_along(const Scene& scene, MediumHandle medium,
                                             const Ray& ray, float end) {
  if (!medium) return Rgb(0);
  return optical_depth(scene.media[medium.index].extinction, end * length(ray.direction));
}

// The share of light that comes along the ray, in a scene with boundaries to cross.
template <class A>
[[nodiscard]] inline Rgb light_through_boundaries(const PathContext<A>& context, Ray ray,
                                                  MediumHandle medium, TileCounts& counts) {
  const Scene& scene = context.scene;
  Vec3f wo = -normalize(ray.direction);
  Rgb depth(0);
  for (int crossed = 0; crossed <= most_boundaries; ++crossed) {
    if (!is_traceable(ray)) return Rgb(0);
    ++counts.rays.shadow;
    Hit hit = context.accelerator.intersect(ray);
    if (!hit.is_hit()) {
      depth += optical_depth_along(scene, medium, ray, ray.t_max);
      return transmittance_of(depth);
    }
    if (!is_clear_boundary(scene, hit)) return Rgb(0);
    const SurfacePoint met = met_point(scene, hit, wo);
    const bool scatters = medium && scene.media[medium.index].scatters();
    const float end = scatters ? end_in_medium(hit.t, met, ray.direction) : hit.t;
    depth += optical_depth_along(scene, medium, ray, end);
    medium = medium_beyond(scene, hit, met, medium);
    ray = shadow_ray_behind(ray, met);
    if (ray.t_max == 0) return transmittance_of(depth);
  }
  return Rgb(0);
}

// The share of light that comes along a traceable shadow ray which starts in `medium`.
template <class A>
[[nodiscard]] inline Rgb light_along(const PathContext<A>& context, const Ray& ray,
                                     MediumHandle medium, TileCounts& counts) {
  const Scene& scene = context.scene;
  if (scene.features.clear_boundaries)
    return light_through_boundaries(context, ray, medium, counts);
  ++counts.rays.shadow;
  if (context.accelerator.occluded(ray)) return Rgb(0);
  return transmittance_of(optical_depth_along(scene, medium, ray, ray.t_max));
}

}  // namespace candela
