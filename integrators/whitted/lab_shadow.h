// Hard shadows that step through holes (docs/cli.md, "Whitted and raster").
//
// The lab starts rays at t >= 0.01 in the scene's unit; here their origins are moved off surfaces
// by the bound of their rounding error, so that no scene leaks for being small.
#pragma once

#include "integrators/tile_counts.h"
#include "integrators/whitted/lab_point.h"
#include "renderer/accel/accelerator.h"
#include "renderer/light/light.h"
#include "renderer/light/shadow_segment.h"

namespace candela {

// Holes that a ray steps through: a guard against rounding; no scene has so many layers.
inline constexpr int most_lab_layers = 10'000;

// Whether the hit is on the lamp that the light stands for.
[[nodiscard]] inline bool is_on_lamp(const Scene& scene, const Light& light, const Hit& hit) {
  const bool is_one_lamp = scene.geometries[hit.geometry].spheres.empty();  // else one a sphere
  return hit.geometry == light.geometry && (is_one_lamp || hit.triangle == light.triangle);
}

// Whether a shadow ray goes on behind what it met: holes, and the lamp that it is cast to.
[[nodiscard]] inline bool passes_light(const Scene& scene, const Light& light, const Hit& hit,
                                       const SurfacePoint& place) {
  const Geometry& geometry = scene.geometries[hit.geometry];
  if (is_on_lamp(scene, light, hit)) return true;
  const Material& worn = scene.materials[geometry.material.index];
  const TexturePoint at = texture_point_of(place);
  const Material& part = greater_part_of_mix(scene.materials, worn, scene.textures, at);
  return lab_alpha_at(worn, part, scene.textures, at) < lab_hole_below;
}

// Steps through holes until a blocker or the light.
template <class A>
[[nodiscard]] inline bool is_lit(const LabContext<A>& context, const Light& light,
                                 const LightSample& sample, TileCounts& counts) {
  Ray ray = sample.shadow_ray;
  if (!context.has_holes && light.geometry == Light::none) {
    ++counts.rays.shadow;
    return is_traceable(ray) && !context.accelerator.occluded(ray);
  }
  for (int step = 0; step < most_lab_layers && is_traceable(ray); ++step) {
    ++counts.rays.shadow;
    const Hit hit = context.accelerator.intersect(ray);
    if (!hit.is_hit()) return true;
    const SurfacePoint place = lab_place(context.scene, hit, -ray.direction);
    if (!passes_light(context.scene, light, hit, place)) return false;
    ray = shadow_ray_behind(ray, place);
    if (ray.t_max == 0) return true;
  }
  return false;
}

}  // namespace candela
