// Next-event estimation: light that reaches a surface point straight from a light.
#pragma once

#include "integrators/path/context.h"
#include "integrators/path/feature_set.h"
#include "integrators/path/strategy.h"
#include "renderer/accel/accelerator.h"
#include "renderer/bsdf/dispatch.h"
#include "renderer/geometry/surface_point.h"
#include "renderer/light/sample_light.h"

namespace candela {

// A direction as the shading frame sees it is a reflection iff it lies above both the shading and
// the geometric surface, a transmission iff below both; what is in between would leak.
[[nodiscard]] inline bool is_consistent(const SurfacePoint& point, const Vec3f& wi_world,
                                        const Vec3f& wi_local) {
  return point.is_flat || (dot(wi_world, point.geometric_normal) > 0) == (wi_local.z > 0);
}

[[nodiscard]] inline LightTables light_tables(const Scene& scene) {
  return {scene.environment ? &*scene.environment : nullptr, &scene.textures};
}

// The contribution of one light sample, already divided by the probability `choice` of the light.
template <FeatureSet F, class A>
[[nodiscard]] inline Rgb light_contribution(const PathContext<A>& context,
                                            const SurfacePoint& point, const Bsdf& bsdf,
                                            const Vec3f& wo_local, const LightSample& light,
                                            float choice, TileCounts& counts) {
  if (!light.is_valid()) return Rgb(0);
  const Vec3f wi_local = point.shading.to_local(light.wi);
  if (!is_consistent(point, light.wi, wi_local)) {
    ++counts.skipped.shadow_rays;
    return Rgb(0);
  }
  const BsdfEvaluation f = evaluate_bsdf<F.models>(bsdf, wo_local, wi_local);
  const float pdf = light.pdf * choice;
  const float weight = light.is_delta ? 1.0f : light_sample_weight<F>(context.options, pdf, f.pdf);
  const Rgb contribution = f.value * light.radiance * (weight / pdf);
  if (is_black(contribution)) {
    ++counts.skipped.shadow_rays;
    return Rgb(0);
  }
  const Ray& ray = light.shadow_ray;
  if (!is_traceable(ray)) return Rgb(0);
  ++counts.rays.shadow;
  return context.accelerator.occluded(ray) ? Rgb(0) : contribution;
}

// The sum over the lights that are sampled at every hit, and one that is picked by power.
template <FeatureSet F, class A>
[[nodiscard]] inline Rgb direct_light(const PathContext<A>& context, const Sampler& sampler,
                                      std::uint32_t bounce, const SurfacePoint& point,
                                      const Bsdf& bsdf, const Vec3f& wo_local, TileCounts& counts) {
  const Scene& scene = context.scene;
  const LightTables tables = light_tables(scene);
  const auto contribution = [&](std::uint32_t index, Vec2f u, float choice) {
    const LightSample light = sample_light(tables, scene.lights[index], point, u);
    return light_contribution<F>(context, point, bsdf, wo_local, light, choice, counts);
  };
  Rgb sum(0);
  if constexpr (F.delta_lights) {
    for (const std::uint32_t index : scene.light_sampler.always())
      sum += contribution(index, Vec2f(0), 1);
  }
  if (scene.light_sampler.has_table()) {
    const LightPick pick =
        scene.light_sampler.pick(sampler.sample_1d_bits(bounce, Dimension::LightChoice));
    sum += contribution(pick.light, sampler.sample_2d(bounce, Dimension::LightPoint),
                        pick.probability);
  }
  return sum;
}

}  // namespace candela
