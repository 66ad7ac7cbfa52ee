// A step of a path in a scene with media: as path_step.h, and collisions between surfaces.
#pragma once

#include "integrators/path/media_flight.h"
#include "integrators/path/path_step.h"
#include "renderer/medium/phase_function.h"

namespace candela {

// Light that dense white media take nothing of leaves them after thousands of collisions; roulette
// that takes more a step than they do would leave it to a few paths of huge weights.
inline constexpr float highest_survival_in_media = 0.9999f;

// Where a medium scatters, as light sampling wants it: a point without a surface.
[[nodiscard]] inline SurfacePoint free_point(const Vec3f& place) {
  SurfacePoint point;
  point.position = place;
  return point;
}

// The contribution of one light where a medium scatters; `choice`: the light's probability.
template <FeatureSet F, class A>
[[nodiscard]] inline DirectLight light_on_medium(const PathContext<A>& context, std::uint32_t index,
                                                 Vec2f u, float choice, const Vec3f& place,
                                                 float asymmetry, const Vec3f& wo) {
  const Scene& scene = context.scene;
  LightSample light =
      sample_light<F.light_kinds()>(light_tables(scene), scene.lights[index], free_point(place), u);
  if (!light.is_valid()) return {};
  const float phase = phase_function(asymmetry, wo, light.wi);
  const float pdf = light.pdf * choice;
  const float weight = light.is_delta ? 1.0f : light_sample_weight<F>(context.options, pdf, phase);
  return {light.radiance * (phase * weight / pdf), light.shadow_ray};
}

// Of all lights but the picked one, which is left to the caller.
template <FeatureSet F, class A>
[[nodiscard]] inline Rgb light_on_medium_from_always(const PathContext<A>& context,
                                                     const Vec3f& place, MediumHandle medium,
                                                     const Vec3f& wo, TileCounts& counts) {
  Rgb sum(0);
  const float asymmetry = context.scene.media[medium.index].asymmetry;
  for (const std::uint32_t index : context.scene.light_sampler.always()) {
    DirectLight light = light_on_medium<F>(context, index, Vec2f(0), 1, place, asymmetry, wo);
    sum += shadowed_in(context, light, medium, counts);
  }
  return sum;
}

// Adds the light that reaches a collision straight from lights and scatters; false where the path
// ends.
template <FeatureSet F, class A>
[[nodiscard]] inline bool scatter_in_medium(const PathContext<A>& context,
                                            const StepNumbers& numbers, std::uint32_t bounce,
                                            const Vec3f& place, MediumHandle medium, Ray& ray,
                                            PathState& path, DirectLight& picked,
                                            TileCounts& counts) {
  const float asymmetry = context.scene.media[medium.index].asymmetry;
  Vec3f wo = -ray.direction;
  if (!F.strategies || samples_lights(context.options.sampling)) {
    path.radiance +=
        path.throughput * light_on_medium_from_always<F>(context, place, medium, wo, counts);
    const LightSampler& lights = context.scene.light_sampler;
    path.light_cell = LightCells::everywhere;  // media go on beyond all cells
    if (lights.has_table()) {
      Vec2f u = numbers.light_point;
      LightPick pick = pick_light(lights, path.light_cell, numbers.light_choice, u);
      picked = light_on_medium<F>(context, pick.light, u, pick.probability, place, asymmetry, wo);
      picked.contribution *= path.throughput;
    }
  }
  PhaseSample next = sample_phase_function(asymmetry, wo, numbers.direction);
  path.bsdf_pdf = next.pdf;
  path.is_delta = false;
  path.receiving_normal = Vec3f(0);
  ray = {place, next.wi, infinity};
  return survives_roulette(numbers.roulette, bounce, context.roulette, path,
                           highest_survival_in_media);
}

// As step(); `medium`: around the path. `shadow_medium`: where the picked light's ray starts.
template <FeatureSet F, class A>
[[nodiscard]] inline bool step_in_media(const PathContext<A>& context, const StepNumbers& numbers,
                                        std::uint32_t bounce, const Hit& hit, Ray& ray,
                                        MediumHandle& medium, PathState& path, DirectLight& picked,
                                        MediumHandle& shadow_medium, float& alpha,
                                        FilmSample& first_hit, TileCounts& counts) {
  const Scene& scene = context.scene;
  Vec3f from = ray.origin;
  MediaFlight flight = fly(context, numbers.free_flight, hit, ray, medium, path, counts);
  if (is_black(path.throughput)) return false;
  if (flight.collides) {
    if (bounce >= context.max_depth) return false;
    shadow_medium = medium;
    return scatter_in_medium<F>(context, numbers, bounce, flight.place, medium, ray, path, picked,
                                counts);
  }
  if (!flight.hit.is_hit()) {
    if (sees_environment(scene, context.options, bounce))
      add_environment<F>(scene, context.options, ray.direction,
                         environment_radiance(*scene.environment, scene.textures, ray.direction),
                         path);
    if (bounce == 0) alpha = 0;
    return false;
  }
  const Geometry& geometry = scene.geometries[flight.hit.geometry];
  Vec3f wo = -ray.direction;
  SurfacePoint point = met_point_at<F>(scene, flight.hit, wo);
  const Material& material = material_at(scene, geometry, point, numbers.material);
  set_material_frame(scene, material, wo, point);
  if (!arrive<F>(context, bounce, flight.hit, ray, from, flight.distance, material, path,
                 first_hit))
    return false;
  NearAndFarMedium media{medium, medium};
  if (!scene.medium_boundaries.empty())
    media = media_beside(scene.medium_boundaries[geometry.material.index], point.is_front, medium);
  const bool goes_on = leave_surface<F>(context, numbers, bounce, point, material, wo, media, ray,
                                        path, picked, counts);
  medium = medium_towards(media, point, ray.direction);
  shadow_medium = medium_towards(media, point, picked.shadow_ray.direction);
  return goes_on;
}

}  // namespace candela
