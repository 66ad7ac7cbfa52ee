// The steps of those paths of a block that met flat diffuse surfaces, all at once: what single
// steps (path_step.h) do, bit by bit.
#pragma once

#include "integrators/path/diffuse_lanes.h"
#include "integrators/path/path_block.h"

namespace candela {

// Which lanes of a block have a shadow ray, and which a ray to go on with.
struct LanesAfterStep {
  LaneMask shadow_rays = 0;
  LaneMask sky_rays = 0;  // of the shadow rays those whose contribution lacks the sky
  LaneMask going_on = 0;
};

constexpr int fewest_of_vectors = 4;  // lanes that are worth it

// Kernels whose diffuse surfaces have one reflectance each, and are met and lit by nothing but
// triangles that stand where the scene says.
template <FeatureSet F>
inline constexpr bool has_diffuse_lanes =
    !F.textures && !F.instances && !F.delta_lights && !F.environment && !F.spheres && !F.media &&
    !F.strategies && !F.guided;

// Of the hits those on flat diffuse surfaces; none where they are few.
[[nodiscard]] inline LaneMask diffuse_lanes(const Scene& scene, const HitBlock& hits,
                                            LaneMask lanes) {
  LaneMask diffuse = 0;
  for_each_lane(lanes, [&](std::uint32_t i) {
    const Geometry& geometry = scene.geometries[hits[i].geometry];
    const bool is_diffuse =
        scene.materials[geometry.material.index].model == MaterialModel::Diffuse;
    if (is_diffuse && geometry.normals.empty()) diffuse |= 1u << i;
  });
  return std::popcount(diffuse) < fewest_of_vectors ? 0 : diffuse;
}

inline void meet(const Scene& scene, const Hit& hit, const Ray& ray, const Rgb& throughput,
                 std::uint32_t i, MetLanes& met) {
  const Geometry& geometry = scene.geometries[hit.geometry];
  const auto& corners = geometry.triangles[hit.triangle];
  met.corner0.set(i, geometry.positions[corners[0]]);
  met.corner1.set(i, geometry.positions[corners[1]]);
  met.corner2.set(i, geometry.positions[corners[2]]);
  met.u[i] = hit.u;
  met.v[i] = hit.v;
  met.direction.set(i, ray.direction);
  met.reflectance.set(i, scene.materials[geometry.material.index].diffuse.constant);
  met.throughput.set(i, throughput);
}

inline void pick_lamp(const Scene& scene, const StepNumbers& numbers, std::uint32_t i,
                      LampLanes& lamps) {
  Vec2f u = numbers.light_point;
  const LightPick pick = pick_light(scene.light_sampler, numbers.light_choice, u);
  const Light& light = scene.lights[pick.light];
  lamps.light[i] = pick.light;
  lamps.is_triangle[i] = light.kind == LightKind::Triangle ? 1 : 0;
  lamps.emits_both_sides[i] = light.emits_both_sides ? 1 : 0;
  lamps.position.set(i, light.position);
  lamps.edge1.set(i, light.edge1);
  lamps.edge2.set(i, light.edge2);
  lamps.normal.set(i, light.normal);
  lamps.emission.set(i, light.emission);
  lamps.area[i] = light.area;
  lamps.offset[i] = light.offset;
  lamps.near_distance2[i] = light.near_distance2;
  lamps.probability[i] = pick.probability;
  lamps.u_x[i] = u.x;
  lamps.u_y[i] = u.y;
}

// The lamp that is near to its path's surface is sampled alone.
template <FeatureSet F, class A>
[[gnu::noinline]] void add_near_lamp(const PathContext<A>& context, std::uint32_t i,
                                     PathBlock& block, LanesAfterStep& after, TileCounts& counts) {
  const DiffuseLanes& lanes = block.diffuse;
  const LampLanes& lamps = lanes.lamps;
  SurfacePoint point = point_of(lanes.met, i);
  Bsdf bsdf{.diffuse = lanes.met.reflectance[i]};
  DirectLight picked = sample_direct_light<F>(
      context, lamps.light[i], Vec2f(lamps.u_x[i], lamps.u_y[i]), lamps.probability[i], point, bsdf,
      {}, point.shading.to_local(-lanes.met.direction[i]), counts);
  picked.contribution *= lanes.met.throughput[i];
  if (is_black(picked.contribution) || !is_traceable(picked.shadow_ray)) return;
  block.shadow_rays[i] = picked.shadow_ray;
  block.unshadowed[i] = picked.contribution;
  after.shadow_rays |= 1u << i;
}

template <FeatureSet F, class A>
inline void light_lanes(const PathContext<A>& context, const BlockNumbers& numbers, LaneMask lanes,
                        PathBlock& block, LanesAfterStep& after, TileCounts& counts) {
  const Scene& scene = context.scene;
  if (!scene.light_sampler.has_table()) return;
  LampLanes& lamps = block.diffuse.lamps;
  for_each_lane(lanes, [&](std::uint32_t i) { pick_lamp(scene, numbers.lane<F>(i), i, lamps); });
  const LampMasks masks = sample_lamps(context.options, block.diffuse);
  const LaneMask far = lanes & ~masks.near;
  counts.skipped.shadow_rays += static_cast<std::uint64_t>(std::popcount(far & masks.dark));
  for_each_lane(far & masks.shadow_rays, [&](std::uint32_t i) {
    block.shadow_rays[i] = {lamps.shadow_origin[i], lamps.shadow_direction[i], shadow_segment_end};
    block.unshadowed[i] = lamps.contribution[i];
  });
  after.shadow_rays |= far & masks.shadow_rays;
  for_each_lane(lanes & masks.near,
                [&](std::uint32_t i) { add_near_lamp<F>(context, i, block, after, counts); });
}

// The paths in these lanes leave their surfaces, which are in block.diffuse.met; returns those that
// go on.
[[nodiscard]] inline LaneMask scatter_lanes(const RenderOptions& options,
                                            const BlockNumbers& numbers, std::uint32_t bounce,
                                            float inverse_roulette_threshold, LaneMask lanes,
                                            PathBlock& block) {
  const ScatterMasks masks =
      scatter(options, numbers, bounce, inverse_roulette_threshold, block.diffuse);
  const ScatteredLanes& scattered = block.diffuse.scattered;
  LaneMask going_on = 0;
  for_each_lane(lanes & masks.going_on, [&](std::uint32_t i) {
    PathState& path = block.paths[i];
    path.throughput = scattered.throughput[i];
    path.bsdf_pdf = scattered.pdf[i];
    path.receiving_normal = block.diffuse.met.normal[i];
    path.is_delta = false;
    if (set_ray(block, i, {scattered.origin[i], scattered.direction[i], infinity}))
      going_on |= 1u << i;
  });
  return going_on;
}

template <FeatureSet F, class A>
inline void step_diffuse_lanes(const PathContext<A>& context, const BlockNumbers& numbers,
                               std::uint32_t bounce, LaneMask lanes, const HitBlock& hits,
                               PathBlock& block, LanesAfterStep& after, TileCounts& counts) {
  const Scene& scene = context.scene;
  for_each_lane(lanes, [&](std::uint32_t i) {
    const Geometry& geometry = scene.geometries[hits[i].geometry];
    const Ray& ray = block.rays[i];
    if (is_emission_met(context, geometry, bounce))
      add_emission<F>(scene, context.options, geometry, hits[i], ray.origin, ray.direction,
                      hits[i].t, block.paths[i]);
    if (bounce == 0 && context.options.aovs != 0)
      record_camera_hit<F>(scene, context.camera, ray, hits[i],
                           scene.materials[geometry.material.index], block.samples[i]);
    meet(scene, hits[i], ray, block.paths[i].throughput, i, block.diffuse.met);
  });
  if (bounce >= context.max_depth) return;
  find_points(block.diffuse.met);
  light_lanes<F>(context, numbers, lanes, block, after, counts);
  after.going_on |= scatter_lanes(context.options, numbers, bounce,
                                  context.inverse_roulette_threshold, lanes, block);
}

}  // namespace candela
