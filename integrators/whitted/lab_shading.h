// lab3's direct lighting at a point (docs/cli.md, "Whitted and raster"): Blinn-Phong under delta
// lights and an unshadowed ambient term. For whitted and raster.
#pragma once

#include "integrators/first_hit.h"
#include "integrators/whitted/lab_shadow.h"
#include "renderer/light/sample_light.h"
#include "renderer/math/transcendental.h"
#include "renderer/scene/light_tables.h"

namespace candela {

// The highlight's factor of ks, in [0, 1]; neither normalised nor bound to n.l > 0.
[[nodiscard]] inline float lab_highlight(SpecularModel model, float exponent, const Vec3f& n,
                                         const Vec3f& wo, const Vec3f& wi) {
  if (exponent == 0) return 1;  // 0^0 as std::pow has it
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
  const LightTables tables = light_tables(context.scene);
  Rgb sum = context.scene.ambient * surface.kd;
  if (point.geometry.is_emissive())
    sum += emitted_radiance(tables, context.scene.lights[point.geometry.first_light + hit.triangle],
                            hit.u, hit.v, wo);
  for (const Light& light : context.lights) {
    if (is_on_lamp(context.scene, light, hit)) continue;  // its point lies within the surface
    const LightSample sample = sample_light(tables, light, point.place, Vec2f(0));
    if (!sample.is_valid()) continue;
    const float highlight =
        lab_highlight(context.rules.specular, surface.exponent, n, wo, sample.wi);
    const Rgb contribution =
        sample.radiance * (surface.kd * std::max(0.0f, dot(n, sample.wi)) + surface.ks * highlight);
    if (is_black(contribution)) {
      ++counts.skipped.shadow_rays;
      continue;
    }
    if (!context.rules.shadows || is_lit(context, light, sample, counts)) sum += contribution;
  }
  return sum;
}

// The layers of the film, from the first surface that is no hole.
template <class A>
inline void lab_record_first(const LabContext<A>& context, const LabPoint& point, const Vec3f& wo,
                             FilmSample& sample) {
  if (sample.has_hit || context.options.aovs == 0 || point.surface.alpha < lab_hole_below) return;
  const Bsdf bsdf = bsdf_at(point.material, context.scene.textures, texture_point_of(point.place),
                            point.place.is_front);
  record_first_hit(context.scene, context.camera, point.geometry, point.place, bsdf,
                   point.place.shading.to_local(wo), sample);
}

}  // namespace candela
