// lab3's direct lighting at a hit [LAB3 section 7]: Blinn-Phong under delta lights and an
// unshadowed ambient term. For whitted and raster.
//
// The lab starts rays at t >= 0.01 in the scene's unit; here their origins are moved off surfaces
// by the bound of their rounding error, so that no scene leaks for being small.
#pragma once

#include <vector>

#include "integrators/first_hit.h"
#include "integrators/tile_counts.h"
#include "integrators/whitted/lab_lights.h"
#include "integrators/whitted/lab_surface.h"
#include "renderer/geometry/surface_point.h"
#include "renderer/light/sample_light.h"
#include "renderer/material/bump.h"
#include "renderer/math/transcendental.h"

namespace candela {

// What tells whitted and raster apart beside their walks, and what the user may choose.
struct LabRules {
  int max_depth = 5;
  SpecularModel specular = SpecularModel::Blinn;
  bool shadows = true;
  bool bump = false;         // the lab's rasteriser reads height maps, its ray tracer does not
  bool lab_normals = false;  // RenderOptions::lab_normals
};

template <class A>
struct LabContext {
  const Scene& scene;
  const A& accelerator;
  const Camera& camera;
  const RenderOptions& options;
  LabRules rules;
  std::vector<Light> lights;  // lab_lights
  bool has_holes = true;      // some surface may let shadow rays through
};

// A hit, its material and its place.
struct LabPoint {
  const Geometry& geometry;
  const Material& material;
  SurfacePoint place;
  LabSurface surface;
  Vec3f normal;  // to shade with
};

[[nodiscard]] inline SurfacePoint lab_place(const Scene& scene, const Hit& hit, const Vec3f& wo) {
  const Instance* instance = hit.is_instanced() ? &scene.instances[hit.instance] : nullptr;
  return make_surface_point(scene.geometries[hit.geometry], instance, hit, wo, true);
}

// As the lab's code interpolates vertex normals: neither unit nor turned to the viewer.
[[nodiscard]] inline Vec3f interpolated_normal(const Scene& scene, const Hit& hit,
                                               const SurfacePoint& place) {
  const Geometry& geometry = scene.geometries[hit.geometry];
  if (geometry.normals.empty()) return place.front_normal;
  const auto& [a, b, c] = geometry.triangles[hit.triangle];
  const auto vertex_normal = [&](std::uint32_t v) {
    const Vec3f& n = geometry.normals[v];
    return hit.is_instanced() ? normalize(scene.instances[hit.instance].normal(n)) : n;
  };
  const Vec3f n =
      vertex_normal(a) * (1 - hit.u - hit.v) + vertex_normal(b) * hit.u + vertex_normal(c) * hit.v;
  return length_squared(n) > 0 ? n : place.front_normal;  // zero: there is none here
}

// Normals are unit and on the side of wo unless the lab's own are asked for.
[[nodiscard]] inline LabPoint lab_point_at(const Scene& scene, const LabRules& rules,
                                           const Hit& hit, const Vec3f& wo) {
  const Geometry& geometry = scene.geometries[hit.geometry];
  const Material& material = scene.materials[geometry.material.index];
  SurfacePoint place = lab_place(scene, hit, wo);
  if (rules.bump && has_bump(material)) {
    place.front_normal = shading_normal_at(material, scene.textures, place.uv, place.front_normal,
                                           place.dpdu, place.dpdv);
    place.is_flat = false;
  }
  set_shading_frame(place, wo);
  return {geometry, material, place, lab_surface_at(material, scene.textures, place.uv),
          rules.lab_normals ? interpolated_normal(scene, hit, place) : place.shading.z};
}

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

// The highlight's factor of ks, in [0, 1]; neither normalised nor bound to n.l > 0.
[[nodiscard]] inline float lab_highlight(SpecularModel model, float exponent, const Vec3f& n,
                                         const Vec3f& wo, const Vec3f& wi) {
  const Vec3f half = wi + wo;
  const float length2 = length_squared(half);
  const float cosine = model == SpecularModel::Phong
                           ? dot(n * (2 * dot(n, wi)) - wi, wo)
                           : (length2 > 0 ? dot(n, half) / std::sqrt(length2) : 0.0f);
  return power(std::min(cosine, 1.0f), static_cast<double>(exponent));
}

// Light that the point sends along wo: its own, the ambient term's and that of all lights.
template <class A>
[[nodiscard]] inline Rgb lab_light_at(const LabContext<A>& context, const LabPoint& point,
                                      const Hit& hit, const Vec3f& wo, TileCounts& counts) {
  const LabSurface& surface = point.surface;
  const Vec3f& n = point.normal;
  Rgb sum = context.scene.ambient * surface.kd;
  if (point.geometry.is_emissive())
    sum += emitted_radiance(context.scene.lights[point.geometry.first_light + hit.triangle], wo);
  for (const Light& light : context.lights) {
    const LightSample sample = sample_light({}, light, point.place.position, Vec2f(0));
    if (!sample.is_valid()) continue;
    const float highlight =
        lab_highlight(context.rules.specular, surface.exponent, n, wo, sample.wi);
    const Rgb contribution =
        sample.radiance * (surface.kd * std::max(0.0f, dot(n, sample.wi)) + surface.ks * highlight);
    if (is_black(contribution)) {
      ++counts.skipped.shadow_rays;
      continue;
    }
    if (!context.rules.shadows || is_lit(context, point.place, light, sample, counts))
      sum += contribution;
  }
  return sum;
}

// The layers of the film, from the first surface that is no hole.
template <class A>
inline void lab_record_first(const LabContext<A>& context, const LabPoint& point, const Vec3f& wo,
                             FilmSample& sample) {
  if (sample.has_hit || context.options.aovs == 0 || point.surface.alpha < lab_hole_below) return;
  const Bsdf bsdf =
      bsdf_at(point.material, context.scene.textures, point.place.uv, point.place.is_front);
  record_first_hit(context.scene, context.camera, point.geometry, point.place, bsdf,
                   point.place.shading.to_local(wo), sample);
}

}  // namespace candela
