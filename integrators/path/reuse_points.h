// The points that paths meet after their first hits, as they serve others (path_reuse.h).
#pragma once

#include "integrators/path/path_block.h"
#include "integrators/path/reuse_lanes.h"
#include "integrators/path/shared_surfaces.h"

namespace candela {

// Where a path met a surface; false where it is seen with a normal that is bent.
[[nodiscard]] inline bool place_point(const Scene& scene, const Hit& hit, const Vec3f& wo,
                                      std::uint32_t i, SharedPointLanes& y) {
  const Material& material = material_of(scene, hit.geometry);
  const SurfacePoint point = has_bump(material)
                                 ? surface_point_at<general_features>(scene, hit, material, wo)
                                 : bare_point_at(scene, hit, wo);
  const Vec3f& geometric = point.geometric_normal;
  Vec3f shading = geometric;
  if (!point.is_flat) {
    const float side = dot(point.front_normal, geometric);
    shading = side < 0 ? -point.front_normal : point.front_normal;
    if (!is_unbent(dot(shading, wo), std::abs(side), dot(geometric, wo))) return false;
    y.are_flat = false;
  }
  y.position.set(i, point.position + geometric * point.offset);
  y.shading_normal.set(i, shading);
  y.geometric_normal.set(i, geometric);
  y.between[i] = dot(shading, geometric);
  return true;
}

// From now on what the path in lane i brings is kept apart.
inline void set_apart(const Scene& scene, std::uint32_t i, PathBlock& block, SharedPointLanes& y) {
  y.before.set(i, block.paths.radiance[i]);
  block.paths.radiance.set(i, Rgb(0));
  y.importance[i] = max_component(block.paths.throughput[i]);
  block.paths.throughput.set(i, Rgb(1));
  if (is_lambertian(scene, block.hits.geometry[i])) return;
  y.glossy |= 1u << i;
  y.wo.set(i, -block.rays.direction[i]);
}

// `shared`: what points that serve others bring to all first hits together. A highlight at y shines
// for the path's own first hit alone.
inline void find_importance(const Lanes<float>& shared, LaneMask gives, SharedPointLanes& y) {
  for_each_lane(gives, [&](std::uint32_t i) {
    if (!(shared[i] > 0)) return;  // by rounding not even its own path's first hit is served
    const bool is_glossy = (y.glossy >> i & 1) != 0;
    y.importance[i] = is_glossy ? (y.importance[i] + shared[i]) / 2 : shared[i];
  });
}
// Roulette goes on by it.
inline void scale_roulette(const SharedPointLanes& y, LaneMask apart, PathLanes& paths) {
  for_each_lane(apart, [&](std::uint32_t i) { paths.roulette_scale[i] *= y.importance[i]; });
}

// All but which lanes there are.
inline void reset_points(SharedPointLanes& y) {
  y.are_flat = true;
  y.even.x.fill(1);
  y.even.y = y.even.z = y.even.x;
  y.towards_x = y.onward = y.even;
  y.shaped = y.direct = y.direct_glossy = {};
  y.shapes = {};
  y.glossy = 0;
}

// The share of light from a direction that a surface sends back by its diffuse lobe, over what the
// lobe lets out. Unit directions.
[[nodiscard]] inline Rgb diffuse_share(const SurfaceMet& met, const Vec3f& wo, const Vec3f& wi) {
  const Frame& frame = met.point.shading;
  const Vec3f wi_local = frame.to_local(wi);
  if (!(wi_local.z > 0)) return Rgb(0);
  const Rgb all =
      evaluate_bsdf<models_with_shared_lobes>(met.bsdf, frame.to_local(wo), wi_local).value;
  const Rgb diffuse = met.lobe.value_below(wi_local.z);
  Rgb share(0);
  for (int c = 0; c < 3; ++c)
    if (all[c] > 0) share[c] = diffuse[c] / all[c];
  return share;
}

// The path in lane i has left a glossy point, to which its shadow rays have brought light. Parts
// what it sends back by its diffuse lobe from the rest.
inline void leave_point(const Scene& scene, std::uint32_t i, const LanesAfterStep& after,
                        PathBlock& block, SharedPointLanes& y) {
  const Vec3f wo = y.wo[i];
  const SurfaceMet met = surface_met(scene, block.hits[i], wo);
  const SurfaceCrossing& crossing = met.lobe.crossing;
  y.even.set(i, crossing.even);
  y.shaped.set(i, crossing.shaped);
  y.towards_x.set(i, met.lobe.crossing_o);
  y.shapes.set(i, crossing);

  Rgb direct(0);
  const std::span<const std::uint32_t> lights = scene.light_sampler.always();
  if (const Rgb always = y.always[i]; !lights.empty() && !is_black(always)) {
    const LightOrSky sample =
        sample_light_or_sky<general_features>(scene, lights[0], met.point, Vec2f(0));
    direct += always * diffuse_share(met, wo, sample.light.wi);
  }
  if ((after.arriving >> i & 1) != 0) {
    const Vec3f wi = normalize(block.shadow_rays.direction[i]);  // a finite light's is not unit
    direct += block.unshadowed[i] * diffuse_share(met, wo, wi);
  }
  y.direct.set(i, direct);
  y.direct_glossy.set(i, glm::max(block.paths.radiance[i] - met.lobe.crossing_o * direct, Rgb(0)));
  block.paths.radiance.set(i, Rgb(0));
  const bool by_density = (after.going_on >> i & 1) != 0 && block.paths.is_delta[i] == 0;
  y.onward.set(i, by_density ? diffuse_share(met, wo, block.rays.direction[i]) : Rgb(0));
}

// What the lobe at y sends out, before it crosses the surface, of a path that has ended.
[[nodiscard]] inline Rgb shared_light(const SharedPointLanes& y, std::uint32_t i,
                                      const Rgb& radiance) {
  return y.direct[i] + y.onward[i] * radiance;
}
// What the other lobes send to x.
[[nodiscard]] inline Rgb glossy_light(const SharedPointLanes& y, std::uint32_t i,
                                      const Rgb& radiance) {
  return y.direct_glossy[i] + glm::max(Rgb(1) - y.towards_x[i] * y.onward[i], Rgb(0)) * radiance;
}

}  // namespace candela
