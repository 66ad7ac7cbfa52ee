// shade(p, wo), the report's path tracer, to be laid beside its section 3 "Implement". The numbered
// comments are its steps; what differs from the printed text is marked (corrected: section) and
// explained in docs/report.md.
//
// The report recurses: shade(p, wo) = L_dir + shade(q, -wi) f cos / pdf / P_RR. Here the same is a
// loop: `weight` is the product of f cos / pdf / P_RR along the path so far.
//
// Unbiased for diffuse, CookTorrance and Lab surfaces under emitting triangles, where no emitter
// reflects; anything else is refused before (check_report.h).
#pragma once

#include "integrators/first_hit.h"
#include "integrators/path/camera_rays.h"
#include "integrators/path/path_step.h"
#include "integrators/plain_direction.h"
#include "integrators/report/ggx_half_vector.h"
#include "integrators/report/report_context.h"

namespace candela {

// Where light meets a surface, and what the report calls p and wo.
struct ReportPoint {
  SurfacePoint p;
  Bsdf bsdf;
  Vec3f wo{0};  // in the shading frame
};

// 1. L_dir = Le f cos(theta) cos(theta') / distance^2 / pdf_light, pdf_light = 1 / LightArea, of
// one point uniform over all lamps, unless something is in the way.
template <class A>
[[nodiscard]] inline Rgb light_of_lamps(const ReportContext<A>& context, const Sampler& sampler,
                                        std::uint32_t bounce, const ReportPoint& at,
                                        TileCounts& counts) {
  if (context.emitters.is_empty()) return Rgb(0);
  const Scene& scene = context.base.scene;
  const std::uint32_t index =
      context.emitters.pick(sampler.sample_1d_bits(bounce, Dimension::LightChoice));
  const Light& lamp = scene.lights[index];
  const LightSample x =
      sample_triangle_light(lamp, at.p, sampler.sample_2d(bounce, Dimension::LightPoint));
  const Vec3f wi = at.p.shading.to_local(x.wi);
  if (!x.is_valid() || !is_consistent(at.p, x.wi, wi)) return Rgb(0);
  const Rgb f_cos = evaluate_bsdf(at.bsdf, at.wo, wi).value;
  if (is_black(f_cos)) return Rgb(0);

  const Ray& ray = x.shadow_ray;  // ends short of the lamp (corrected: 3.1)
  if (!is_traceable(ray)) return Rgb(0);
  ++counts.rays.shadow;
  if (context.base.accelerator.occluded(ray)) return Rgb(0);
  const float cos_lamp = std::abs(dot(lamp.normal, x.wi));
  const float distance2 = x.pdf * cos_lamp * lamp.area;  // x.pdf is that of the solid angle
  return x.radiance * f_cos * cos_lamp / distance2 / context.emitters.pdf_area(scene, index);
}

// The share of the indirect rays that follow the GGX lobe: 0 where ks = 0.
[[nodiscard]] inline float half_vector_probability(const Bsdf& bsdf, float cos_o) {
  if (bsdf.model == BsdfModel::CompensatedCookTorrance)
    return compensated_specular_probability(bsdf, cos_o);
  if (bsdf.model == BsdfModel::CookTorrance) return cook_torrance_specular_probability(bsdf, cos_o);
  return bsdf.model == BsdfModel::Lab ? lab_specular_probability(bsdf, cos_o) : 0.0f;
}

// 3. A direction for the reflected light: cosine-weighted, theta = arccos sqrt(1 - xi) (corrected:
// 3.8), and where ks > 0 one of that and the mirror direction about a half vector. The density is
// that of both together, p_ggx = D (n.h) / (4 (wo.h)) (corrected: 3.9, 3.10). `weight` is all of
// f cos / pdf; zero below the surface. For comparison (4.2): uniform or cosine-weighted directions
// whatever the material.
[[nodiscard]] inline BsdfSample sample_reflection(SamplingStrategy strategy, const Sampler& sampler,
                                                  std::uint32_t bounce, const ReportPoint& at) {
  const Vec2f xi = sampler.sample_2d(bounce, Dimension::Direction);
  if (!samples_bsdfs(strategy)) return sample_plain_direction(strategy, at.bsdf, at.wo, 0, xi);
  const float a = ggx_width(at.bsdf.alpha);
  const float p_ggx = half_vector_probability(at.bsdf, at.wo.z);
  const bool is_ggx = sampler.sample_1d(bounce, Dimension::LobeChoice) < p_ggx;
  const Vec3f wi = is_ggx ? reflect_about(at.wo, sample_ggx_half_vector(a, xi))
                          : square_to_cosine_hemisphere(xi);
  const float pdf =
      p_ggx * ggx_half_vector_pdf(at.wo, wi, a) + (1 - p_ggx) * cosine_hemisphere_pdf(wi.z);
  return to_sample(wi, {evaluate_bsdf(at.bsdf, at.wo, wi).value, pdf});
}

// The radiance that a lamp sends towards wo; zero for other surfaces and for the backs of lamps.
[[nodiscard]] inline Rgb emitted_towards(const Scene& scene, const Hit& hit, const Vec3f& wo) {
  const Geometry& geometry = scene.geometries[hit.geometry];
  if (!geometry.is_emissive()) return Rgb(0);
  return triangle_light_radiance(scene.lights[geometry.first_light + hit.triangle], wo);
}

template <class A>
[[nodiscard]] inline FilmSample shade(const ReportContext<A>& context, const Sampler& sampler,
                                      const Ray& camera_ray, TileCounts& counts) {
  const Scene& scene = context.base.scene;
  FilmSample sample;
  Rgb weight(1);
  Ray ray = camera_ray;
  ++counts.rays.camera;
  for (std::uint32_t bounce = 0;; ++bounce) {
    if (!is_traceable(ray)) {
      sample.radiance = invalid_radiance;
      break;
    }
    const Hit hit = context.base.accelerator.intersect(ray);
    if (bounce == 0 && !hit.is_hit()) sample.alpha = 0;
    if (!hit.is_hit()) break;  // nothing comes from outside of the scene
    const Vec3f wo = -ray.direction;
    const Geometry& geometry = scene.geometries[hit.geometry];
    const Material& material = scene.materials[geometry.material.index];
    const SurfacePoint p = surface_point_at<media_features>(scene, hit, material, wo);
    const Bsdf bsdf = bsdf_at(material, scene.textures, texture_point_of(p), p.is_front);
    const ReportPoint at{p, bsdf, p.shading.to_local(wo)};
    if (bounce == 0 && context.base.options.aovs != 0)
      record_first_hit(scene, context.base.camera, geometry, p, bsdf, at.wo, sample);

    // 4. "if the ray hits a q that does not emit": what lamps send was counted at p by step 1, and
    // they reflect nothing. Only the camera sees them (corrected: 3.0).
    const Rgb emitted = emitted_towards(scene, hit, wo);
    if (!is_black(emitted)) {
      if (bounce == 0) sample.radiance = emitted;
      break;
    }
    if (bounce >= context.base.max_depth) break;

    sample.radiance += weight * light_of_lamps(context, sampler, bounce, at, counts);  // 1.

    // 2. "if random_float > P_RR return L_dir".
    if (!(sampler.sample_1d(bounce, Dimension::Roulette) < context.p_rr)) break;

    const BsdfSample reflection =
        sample_reflection(context.base.options.sampling, sampler, bounce, at);  // 3.
    if (is_black(reflection.weight)) break;
    const Vec3f wi = p.shading.to_world(reflection.wi);
    if (!is_consistent(p, wi, reflection.wi)) break;

    // 4. L_indir = shade(q, -wi) f cos(theta) / pdf / P_RR.
    weight *= reflection.weight / context.p_rr;
    if (is_black(weight)) break;
    ray = spawn_ray(p, wi);
    ++counts.rays.indirect;
  }
  return sample;  // 5. L_dir + L_indir
}

// The samples of a pass, in order.
template <class A>
TileCounts render_report_tile(const ReportContext<A>& context, const TilePass& pass, Film& film) {
  const PixelRect& tile = pass.tile;
  TileCounts counts;
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      const SampleRange range = pass.of_pixel(x, y);
      const PixelSampler pixel(pass.seed, static_cast<std::uint32_t>(x),
                               static_cast<std::uint32_t>(y), film.sequences());
      for (std::uint32_t s = range.first; s < range.end; ++s) {
        const Sampler sampler = pixel.at(s);
        const Vec2f place = context.base.filter.sample(sampler.sample_2d(0, Dimension::Filter));
        const Ray ray = context.base.camera.generate_ray(cell_of(context.base, x, y).on_film(place),
                                                         sampler.sample_2d(0, Dimension::Lens));
        FilmSample sample = shade(context, sampler, ray, counts);
        sample.weight = context.base.filter.weight(place);
        add_or_count(sample, x, y, s, context.base.options.clamp, film, counts);
      }
    }
  }
  return counts;
}

}  // namespace candela
