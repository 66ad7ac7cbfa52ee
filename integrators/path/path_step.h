// A step of a path, from where its ray ended to its next ray: next-event estimation at every
// non-delta hit and BSDF sampling, combined by the power heuristic; Russian roulette on throughput
// [Veach97]. Unbiased: no clamp, no depth limit unless asked for.
#pragma once

#include "integrators/first_hit.h"
#include "integrators/path/context.h"
#include "integrators/path/feature_set.h"
#include "integrators/path/guide.h"
#include "integrators/path/next_event.h"
#include "integrators/path/survival.h"
#include "integrators/plain_direction.h"
#include "renderer/light/environment.h"
#include "renderer/material/bsdf_at.h"
#include "renderer/material/bump.h"
#include "renderer/material/mixed_material.h"
#include "renderer/material/texture_point_of.h"

namespace candela {

// The state of a path between two hits.
struct PathState {
  Rgb throughput{1};
  Rgb radiance{0};
  float bsdf_pdf = 0;  // solid angle, of the direction of its ray; with a guide, of both
  // Roulette goes by the throughput times this: what refraction and guides take of the throughput
  // is no loss of light.
  float roulette_scale = 1;
  Vec3f receiving_normal{0};  // where it was scattered, see SurfacePoint
  bool is_delta = true;       // camera rays and delta lobes: only this strategy finds the light
  std::uint32_t light_cell = LightCells::everywhere;  // where it was scattered
  // Of the last step alone: with which probability roulette let it live, and how much likelier a
  // guide made its direction than the BSDF.
  float survival = 1;
  float guide_ratio = 1;

  [[nodiscard]] float roulette_throughput() const {
    return max_component(throughput) * roulette_scale;
  }
};

// The random numbers of a step: 32 random bits, else in [0, 1).
struct StepNumbers {
  std::uint32_t light_choice = 0;
  Vec2f light_point{0};
  float lobe = 0;
  Vec2f direction{0};
  float roulette = 0;
  float material = 0;
  std::uint32_t free_flight = 0;
  float guide_choice = 0;
};

// By which lights are picked at what a ray met.
[[nodiscard]] inline std::uint32_t light_cell_at(const Scene& scene, const Ray& ray, float t,
                                                 std::uint32_t bounce) {
  return scene.light_sampler.cell_of(ray.origin + t * ray.direction, bounce);
}

// Light that the path met; `light_pdf` is the light sampler's density of its direction, 0 where it
// would not have found it.
template <FeatureSet F>
inline void add_met_light(const RenderOptions& options, const Rgb& radiance, float light_pdf,
                          PathState& path) {
  const float weight =
      path.is_delta ? 1.0f : met_light_weight<F>(options, path.bsdf_pdf, light_pdf);
  path.radiance += path.throughput * radiance * weight;
}

// Whether rays that leave the scene meet light.
[[nodiscard]] inline bool sees_environment(const Scene& scene, const RenderOptions& options,
                                           std::uint32_t bounce) {
  if (!scene.environment) return false;
  return bounce > 0 || (!options.transparent && scene.environment->is_seen_by_camera);
}

// Light from a ray that left the scene.
template <FeatureSet F>
inline void add_environment(const Scene& scene, const RenderOptions& options, const Vec3f& wi,
                            const Rgb& radiance, PathState& path) {
  const Environment& environment = *scene.environment;
  const bool is_unsampled = path.is_delta || scene.environment_light == Light::none;
  const float pdf = is_unsampled ? 0.0f
                                 : environment_pdf(environment, wi) *
                                       scene.light_sampler.probability(scene.environment_light);
  add_met_light<F>(options, radiance, pdf, path);
}

// As add_emission(), of a sphere.
template <FeatureSet F>
inline void add_sphere_emission(const Scene& scene, const RenderOptions& options,
                                std::uint32_t index, const Hit& hit, const Vec3f& wi,
                                float distance, PathState& path) {
  const Light& light = scene.lights[index];
  Vec3f direction = from_octahedron({hit.u, hit.v});
  const float pdf = path.is_delta ? 0.0f
                                  : sphere_light_pdf(light, direction, wi, distance) *
                                        scene.light_sampler.probability(index, path.light_cell);
  Rgb radiance = sphere_light_radiance(light, scene.geometries, scene.textures, direction, -wi);
  add_met_light<F>(options, radiance, pdf, path);
}

// The density of next-event estimation for an emitting triangle that a path met: that of the quad
// that it is half of, if it is.
[[nodiscard]] inline float met_triangle_pdf(const Scene& scene, std::uint32_t triangle,
                                            const Vec3f& from, const PathState& path,
                                            const Vec3f& wi, float distance) {
  const std::uint32_t quad = scene.lights[triangle].quad;
  if (quad == Light::none)
    return triangle_light_pdf(scene.lights[triangle], wi, distance) *
           scene.light_sampler.probability(triangle, path.light_cell);
  return quad_light_pdf(scene.lights[quad], from, path.receiving_normal, wi, distance) *
         scene.light_sampler.probability(quad, path.light_cell);
}

// Light that the surface itself sends back along the ray, which was sampled at `from`, at this
// distance.
template <FeatureSet F>
inline void add_emission(const Scene& scene, const RenderOptions& options, const Geometry& geometry,
                         const Hit& hit, const Vec3f& from, const Vec3f& wi, float distance,
                         PathState& path) {
  const std::uint32_t index = geometry.first_light + hit.triangle;
  const Light& light = scene.lights[index];
  if constexpr (F.spheres) {
    if (light.kind == LightKind::Sphere)
      return add_sphere_emission<F>(scene, options, index, hit, wi, distance, path);
  }
  const float pdf = path.is_delta ? 0.0f : met_triangle_pdf(scene, index, from, path, wi, distance);
  Rgb radiance = triangle_light_radiance(light, -wi);
  if (light.texture) radiance *= emission_factor(light, geometry, scene.textures, hit.u, hit.v);
  add_met_light<F>(options, radiance, pdf, path);
}

// Whether add_emission() has anything to add: lamps that camera rays meet may have rays of their
// own.
template <class A>
[[nodiscard]] inline bool is_emission_met(const PathContext<A>& context, const Geometry& geometry,
                                          std::uint32_t bounce) {
  return geometry.is_emissive() && (bounce > 0 || context.lamp_rays == 0);
}

// The material that a hit meets: of mixtures the part that u in [0, 1) chooses.
[[nodiscard]] inline const Material& material_at(const Scene& scene, const Geometry& geometry,
                                                 const SurfacePoint& point, float u) {
  const Material& material = scene.materials[geometry.material.index];
  if (material.model == MaterialModel::Mix)
    return material_of_mix(scene.materials, material, scene.textures, texture_point_of(point), u);
  return material;
}

// Without its shading frame, which is the material's.
template <FeatureSet F>
[[nodiscard]] inline SurfacePoint met_point_at(const Scene& scene, const Hit& hit,
                                               const Vec3f& wo) {
  const Instance* instance = instance_of(scene, hit);
  const Geometry& geometry = scene.geometries[hit.geometry];
  if constexpr (F.spheres) return make_surface_point(geometry, instance, hit, wo, true);
  return make_triangle_point(geometry, instance, hit, wo, true);
}

inline void set_material_frame(const Scene& scene, const Material& material, const Vec3f& wo,
                               SurfacePoint& point) {
  if (has_bump(material)) {
    point.front_normal = shading_normal_at(material, scene.textures, texture_point_of(point),
                                           point.front_normal, point.dpdu, point.dpdv);
    point.is_flat = false;
  }
  set_shading_frame(point, wo);
  if (material.follows_tangents)
    point.shading = frame_from_normal_and_tangent(point.shading.z, point.dpdu);
  if (!is_transmissive(material.model)) point.receiving_normal = point.shading.z;
}

template <FeatureSet F>
[[nodiscard]] inline SurfacePoint surface_point_at(const Scene& scene, const Hit& hit,
                                                   const Material& material, const Vec3f& wo) {
  SurfacePoint point = met_point_at<F>(scene, hit, wo);
  set_material_frame(scene, material, wo, point);
  return point;
}

// What the film's layers keep. Out of line: the steps of a path need not have all of it at hand.
template <FeatureSet F>
[[gnu::noinline]] void record_camera_hit(const Scene& scene, const Camera& camera, const Ray& ray,
                                         const Hit& hit, const Material& material,
                                         FilmSample& sample) {
  const Geometry& geometry = scene.geometries[hit.geometry];
  Vec3f wo = -ray.direction;
  SurfacePoint point = surface_point_at<F>(scene, hit, material, wo);
  Bsdf bsdf = bsdf_at(material, scene.textures, texture_point_of(point), point.is_front);
  record_first_hit(scene, camera, geometry, point, bsdf, point.shading.to_local(wo), sample);
}

// A direction drawn from the BSDF, or from what the options ask for.
template <FeatureSet F>
[[nodiscard]] inline BsdfSample sample_direction(const RenderOptions& options,
                                                 const StepNumbers& numbers, const Bsdf& bsdf,
                                                 const Vec3f& wo_local) {
  if constexpr (F.strategies) {
    if (!samples_bsdfs(options.sampling) && !is_only_delta<F.models>(bsdf))
      return sample_plain_direction<F.models>(options.sampling, bsdf, wo_local, numbers.lobe,
                                              numbers.direction);
  }
  return sample_bsdf<F.models>(bsdf, wo_local, numbers.lobe, numbers.direction);
}

// Continues the path in a direction of a sample; false where it ends.
[[nodiscard]] inline bool scatter(const SurfacePoint& point, const BsdfSample& sample, Ray& ray,
                                  PathState& path) {
  if (is_black(sample.weight)) return false;
  Vec3f wi = point.shading.to_world(sample.wi);
  if (!is_consistent(point, wi, sample.wi)) return false;
  path.throughput *= sample.weight;
  path.bsdf_pdf = sample.pdf;
  path.is_delta = sample.is_delta;
  path.receiving_normal = point.receiving_normal;
  path.roulette_scale *= sample.eta * sample.eta;
  ray = spawn_ray(point, wi);
  return true;
}

// Russian roulette: false ends the path, else survivors stand for the ended.
[[nodiscard]] inline bool survives_roulette(float u, std::uint32_t bounce, Roulette roulette,
                                            PathState& path,
                                            float highest = highest_survival_on_surfaces) {
  const float survival =
      survival_probability(bounce, path.roulette_throughput(), roulette, highest);
  if (u >= survival) return false;  // not where it is no number, which shall be counted
  path.throughput /= survival;
  path.survival = survival;
  return true;
}

// Continues the path from a surface; false where it ends.
template <FeatureSet F>
[[nodiscard]] inline bool scatter_from(const RenderOptions& options, const StepNumbers& numbers,
                                       [[maybe_unused]] const Guide<F>& guide,
                                       const SurfacePoint& point, const Bsdf& bsdf,
                                       const Vec3f& wo_local, Ray& ray, PathState& path) {
  if constexpr (F.guided) {
    if (guide.targets.is_known()) {
      const GuidedSample guided = sample_with_guide<F.models>(
          guide, point, bsdf, wo_local, numbers.guide_choice, numbers.lobe, numbers.direction);
      path.guide_ratio = guided.density_ratio;
      path.roulette_scale *= path.guide_ratio;
      return scatter(point, guided.sample, ray, path);
    }
  }
  return scatter(point, sample_direction<F>(options, numbers, bsdf, wo_local), ray, path);
}

// Adds the light that reaches the surface straight from lights and continues the path; false where
// it ends. The picked light's is left to the caller, who traces its shadow ray.
template <FeatureSet F, class A>
[[nodiscard]] inline bool leave_surface(const PathContext<A>& context, const StepNumbers& numbers,
                                        std::uint32_t bounce, const SurfacePoint& point,
                                        const Material& material, const Vec3f& wo,
                                        MediaBeside<F> media, Ray& ray, PathState& path,
                                        DirectLight& picked, TileCounts& counts) {
  Bsdf bsdf = bsdf_at(material, context.scene.textures, texture_point_of(point), point.is_front);
  Vec3f wo_local = point.shading.to_local(wo);
  const Guide<F> guide = guide_at<F>(context.guide, point, bsdf);
  if (!is_only_delta<F.models>(bsdf) &&
      (!F.strategies || samples_lights(context.options.sampling))) {
    add_light_of_always<F>(context, point, bsdf, guide, wo_local, path.throughput, media,
                           path.radiance, counts);
    picked = picked_light<F>(context, path.light_cell, numbers.light_choice, numbers.light_point,
                             point, bsdf, guide, wo_local, counts);
    picked.contribution *= path.throughput;
  }
  return scatter_from<F>(context.options, numbers, guide, point, bsdf, wo_local, ray, path) &&
         survives_roulette(numbers.roulette, bounce, context.roulette, path);
}

// What a path finds where its ray met a surface, before it leaves it again; false where it ends
// there. `from`: where the ray was sampled, `distance` away. `first_hit`: what the film's layers
// keep of the camera ray.
template <FeatureSet F, class A>
[[nodiscard]] inline bool arrive(const PathContext<A>& context, std::uint32_t bounce,
                                 const Hit& hit, const Ray& ray, const Vec3f& from, float distance,
                                 const Material& material, PathState& path, FilmSample& first_hit) {
  const Scene& scene = context.scene;
  const Geometry& geometry = scene.geometries[hit.geometry];
  if (is_emission_met(context, geometry, bounce))
    add_emission<F>(scene, context.options, geometry, hit, from, ray.direction, distance, path);
  if (bounce == 0 && context.options.aovs != 0)
    record_camera_hit<F>(scene, context.camera, ray, hit, material, first_hit);
  if (bounce >= context.max_depth) return false;
  path.light_cell = light_cell_at(scene, ray, hit.t, bounce);
  return true;
}

// From the surface that the path's ray met to its next ray, which takes its place; false where the
// path ends.
template <FeatureSet F, class A>
[[nodiscard]] inline bool step(const PathContext<A>& context, const StepNumbers& numbers,
                               std::uint32_t bounce, const Hit& hit, Ray& ray, PathState& path,
                               DirectLight& picked, FilmSample& first_hit, TileCounts& counts) {
  const Scene& scene = context.scene;
  Vec3f wo = -ray.direction;
  SurfacePoint point = met_point_at<F>(scene, hit, wo);
  const Material& material =
      material_at(scene, scene.geometries[hit.geometry], point, numbers.material);
  set_material_frame(scene, material, wo, point);
  if (!arrive<F>(context, bounce, hit, ray, ray.origin, hit.t, material, path, first_hit))
    return false;
  return leave_surface<F>(context, numbers, bounce, point, material, wo, {}, ray, path, picked,
                          counts);
}

}  // namespace candela
