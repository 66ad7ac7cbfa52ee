// Hard shadows that step through holes [LAB3 section 7].
//
// The lab starts rays at t >= 0.01 in the scene's unit; here their origins are moved off surfaces
// by the bound of their rounding error, so that no scene leaks for being small.
#pragma once

#include "integrators/tile_counts.h"
#include "integrators/whitted/lab_point.h"
#include "renderer/accel/accelerator.h"
#include "renderer/light/light.h"

namespace candela {

// From `origin` to just before the light, whose wi was found from there or nearby.
[[nodiscard]] inline Ray lab_shadow_ray(const Vec3f& origin, const LightSample& light) {
  if (light.is_infinite) return {origin, light.wi, infinity};
  const Vec3f to_light = light.point - origin;
  const float distance = length(to_light);
  return {origin, to_light / distance, distance * (1 - gamma_bound(16))};
}

// Whether a shadow ray goes on behind what it met: holes, and the lamp that it is cast to.
[[nodiscard]] inline bool passes_light(const Scene& scene, const Light& light, const Hit& hit,
                                       const SurfacePoint& place) {
  if (hit.geometry == light.geometry) return true;
  const Material& material = scene.materials[scene.geometries[hit.geometry].material.index];
  return lab_alpha_at(material, scene.textures, place.uv) < lab_hole_below;
}

// Steps through holes until a blocker or the light.
template <class A>
[[nodiscard]] inline bool is_lit(const LabContext<A>& context, const SurfacePoint& from,
                                 const Light& light, const LightSample& sample,
                                 TileCounts& counts) {
  constexpr int most_steps = 10'000;  // a guard against rounding; no scene has so many layers
  Ray ray = lab_shadow_ray(
      offset_origin(from.position, from.position_error, from.geometric_normal, sample.wi), sample);
  if (!context.has_holes && light.geometry == Light::none) {
    ++counts.rays.shadow;
    return is_traceable(ray) && !context.accelerator.occluded(ray);
  }
  for (int step = 0; step < most_steps && is_traceable(ray); ++step) {
    ++counts.rays.shadow;
    const Hit hit = context.accelerator.intersect(ray);
    if (!hit.is_hit()) return true;
    const SurfacePoint place = lab_place(context.scene, hit, -ray.direction);
    if (!passes_light(context.scene, light, hit, place)) return false;
    const Vec3f behind =
        offset_origin(place.position, place.position_error, place.geometric_normal, sample.wi);
    if (!sample.is_infinite && !(dot(sample.point - behind, sample.wi) > 0)) return true;
    ray = lab_shadow_ray(behind, sample);
  }
  return false;
}

}  // namespace candela
