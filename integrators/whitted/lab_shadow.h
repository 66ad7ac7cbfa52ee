// Hard shadows that step through holes (docs/cli.md, "Whitted and raster").
//
// The lab starts rays at t >= 0.01 in the scene's unit; here their origins are moved off surfaces
// by the bound of their rounding error, so that no scene leaks for being small.
#pragma once

#include "integrators/tile_counts.h"
#include "integrators/whitted/lab_point.h"
#include "renderer/accel/accelerator.h"
#include "renderer/light/light.h"

namespace candela {

// The rest of a shadow ray from behind what it met; t_max 0 where that lies past its end.
[[nodiscard]] inline Ray remaining_shadow_ray(const Ray& ray, const Vec3f& behind) {
  if (ray.t_max == infinity) return {behind, ray.direction, infinity};
  const Vec3f to_end = ray.origin + ray.direction - behind;
  return {behind, to_end, dot(to_end, ray.direction) > 0 ? ray.t_max : 0.0f};
}

// Whether a shadow ray goes on behind what it met: holes, and the lamp that it is cast to.
[[nodiscard]] inline bool passes_light(const Scene& scene, const Light& light, const Hit& hit,
                                       const SurfacePoint& place) {
  if (hit.geometry == light.geometry) return true;
  const Material& worn = scene.materials[scene.geometries[hit.geometry].material.index];
  const TexturePoint at = texture_point_of(place);
  const Material& part = greater_part_of_mix(scene.materials, worn, scene.textures, at);
  return lab_alpha_at(worn, part, scene.textures, at) < lab_hole_below;
}

// Steps through holes until a blocker or the light.
template <class A>
[[nodiscard]] inline bool is_lit(const LabContext<A>& context, const Light& light,
                                 const LightSample& sample, TileCounts& counts) {
  constexpr int most_steps = 10'000;  // a guard against rounding; no scene has so many layers
  Ray ray = sample.shadow_ray;
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
        offset_origin(place.position, place.geometric_normal, place.offset, sample.wi);
    ray = remaining_shadow_ray(ray, behind);
    if (!(ray.t_max > 0)) return true;
  }
  return false;
}

}  // namespace candela
