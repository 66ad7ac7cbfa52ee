// Next-event estimation: light that reaches a surface point straight from a light.
#pragma once

#include "integrators/path/context.h"
#include "integrators/path/feature_set.h"
#include "integrators/path/guide.h"
#include "integrators/path/media_beside.h"
#include "integrators/path/shadow_walk.h"
#include "integrators/path/strategy.h"
#include "renderer/accel/accelerator.h"
#include "renderer/bsdf/dispatch.h"
#include "renderer/geometry/surface_point.h"
#include "renderer/light/sample_light.h"
#include "renderer/scene/light_tables.h"

namespace candela {

// A direction as the shading frame sees it is a reflection iff it lies above both the shading and
// the geometric surface, a transmission iff below both; what is in between would leak.
[[nodiscard]] inline bool is_consistent(const SurfacePoint& point, const Vec3f& wi_world,
                                        const Vec3f& wi_local) {
  return point.is_flat || (dot(wi_world, point.geometric_normal) > 0) == (wi_local.z > 0);
}

// What a light sample brings if nothing stands in its shadow ray's way. A sky's radiance is looked
// up once it is known to arrive, since what costs most is to fetch its texels: until then it is
// missing as a factor.
struct DirectLight {
  Rgb contribution{0};  // black: there is no ray to trace
  Ray shadow_ray;
  bool lacks_sky = false;
};

// The contribution of one light sample, already divided by the probability `choice` of the light.
// `evaluate`: the BSDF of the local direction.
template <FeatureSet F, class Evaluate>
[[nodiscard]] inline Rgb unshadowed_contribution(const RenderOptions& options,
                                                 const SurfacePoint& point, const Guide<F>& guide,
                                                 const Vec3f& wi, float light_pdf, bool is_delta,
                                                 float choice, const Rgb& radiance,
                                                 const Evaluate& evaluate) {
  Vec3f wi_local = point.shading.to_local(wi);
  if (!is_consistent(point, wi, wi_local)) return Rgb(0);
  BsdfEvaluation f = evaluate(wi_local);
  if (is_black(f.value)) return Rgb(0);
  const float pdf = light_pdf * choice;
  const float weight =
      is_delta ? 1.0f : light_sample_weight<F>(options, pdf, path_pdf<F>(guide, wi, f.pdf));
  return f.value * radiance * (weight / pdf);
}

// A direction to the sky as a light sample, as if its radiance were 1.
[[nodiscard]] inline LightSample sky_sample(const EnvironmentSample& sample,
                                            const SurfacePoint& from) {
  if (!(sample.pdf > 0)) return {};
  return {.wi = sample.direction,
          .radiance = Rgb(1),
          .pdf = sample.pdf,
          .shadow_ray = spawn_ray(from, sample.direction)};
}

struct LightOrSky {
  LightSample light;
  bool is_sky;  // its radiance is missing
};
template <FeatureSet F>
[[nodiscard]] inline LightOrSky sample_light_or_sky(const Scene& scene, std::uint32_t index,
                                                    const SurfacePoint& point, Vec2f u) {
  constexpr LightKindSet sky = light_kind_bit(LightKind::Environment);
  if (scene.lights[index].kind == LightKind::Environment)
    return {sky_sample(sample_environment(*scene.environment, u), point), true};
  return {
      sample_light<(F.light_kinds() & ~sky)>(light_tables(scene), scene.lights[index], point, u),
      false};
}

template <FeatureSet F, class A>
[[nodiscard]] inline DirectLight sample_direct_light(const PathContext<A>& context,
                                                     std::uint32_t index, Vec2f u, float choice,
                                                     const SurfacePoint& point, const Bsdf& bsdf,
                                                     const Guide<F>& guide, const Vec3f& wo_local,
                                                     TileCounts& counts) {
  const auto [light, is_sky] = sample_light_or_sky<F>(context.scene, index, point, u);
  Rgb contribution(0);
  if (light.is_valid())
    contribution = unshadowed_contribution<F>(
        context.options, point, guide, light.wi, light.pdf, light.is_delta, choice, light.radiance,
        [&](const Vec3f& wi) { return evaluate_bsdf<F.models>(bsdf, wo_local, wi); });
  if (is_black(contribution)) {
    ++counts.skipped.shadow_rays;
    return {};
  }
  return {contribution, light.shadow_ray, is_sky};
}

// A light for the points of a cell; where the number that chose is u.x, what is left of it takes
// its place.
[[nodiscard]] inline LightPick pick_light(const LightSampler& lights, std::uint32_t cell,
                                          std::uint32_t choice, Vec2f& u) {
  LightPick pick = lights.pick(choice, cell, u);
  if (lights.tells_rest()) u.x = pick.rest;
  return pick;
}

// Of the light that is picked; `choice`: 32 random bits, where the lights are few those of u.x.
template <FeatureSet F, class A>
[[nodiscard]] inline DirectLight picked_light(const PathContext<A>& context, std::uint32_t cell,
                                              std::uint32_t choice, Vec2f u,
                                              const SurfacePoint& point, const Bsdf& bsdf,
                                              const Guide<F>& guide, const Vec3f& wo_local,
                                              TileCounts& counts) {
  const LightSampler& lights = context.scene.light_sampler;
  if (!lights.has_table()) return {};
  LightPick pick = pick_light(lights, cell, choice, u);
  return sample_direct_light<F>(context, pick.light, u, pick.probability, point, bsdf, guide,
                                wo_local, counts);
}

template <class A>
[[nodiscard]] inline Rgb shadowed(const A& accelerator, const DirectLight& light,
                                  TileCounts& counts) {
  if (is_black(light.contribution) || !is_traceable(light.shadow_ray)) return Rgb(0);
  ++counts.rays.shadow;
  return accelerator.occluded(light.shadow_ray) ? Rgb(0) : light.contribution;
}

// The same where media dim the light on its way; `medium`: where the ray starts.
template <class A>
[[nodiscard]] inline Rgb shadowed_in(const PathContext<A>& context, const DirectLight& light,
                                     MediumHandle medium, TileCounts& counts) {
  if (is_black(light.contribution) || !is_traceable(light.shadow_ray)) return Rgb(0);
  return light.contribution * light_along(context, light.shadow_ray, medium, counts);
}

// Adds light of those that are sampled at every hit.
template <FeatureSet F, class A>
inline void add_light_of_always(const PathContext<A>& context, const SurfacePoint& point,
                                const Bsdf& bsdf, const Guide<F>& guide, const Vec3f& wo_local,
                                const Rgb& throughput, [[maybe_unused]] MediaBeside<F> media,
                                Rgb& radiance, TileCounts& counts) {
  for (const std::uint32_t index : context.scene.light_sampler.always()) {
    DirectLight light =
        sample_direct_light<F>(context, index, Vec2f(0), 1, point, bsdf, guide, wo_local, counts);
    light.contribution *= throughput;
    if constexpr (F.media)
      radiance += shadowed_in(context, light,
                              medium_towards(media, point, light.shadow_ray.direction), counts);
    else
      radiance += shadowed(context.accelerator, light, counts);
  }
}

}  // namespace candela
