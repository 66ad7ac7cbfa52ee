// The steps of those paths of a block that met flat surfaces, all at once: what single steps do
// (path_step.h), bit by bit.
#pragma once

#include "integrators/path/flat_lanes.h"
#include "integrators/path/path_block.h"

namespace candela {

// Which lanes of a block have a shadow ray, and which a ray to go on with.
struct LanesAfterStep {
  LaneMask shadow_rays = 0;
  LaneMask sky_rays = 0;  // of the shadow rays those whose contribution lacks the sky
  LaneMask going_on = 0;
};

constexpr int fewest_of_vectors = 4;  // lanes that are worth it

// Kernels whose surfaces are untextured, of two models, and are met and lit by nothing but
// triangles that stand where the scene says.
template <FeatureSet F>
inline constexpr bool has_flat_lanes = F.models == plain_features.models;

// Lanes by the models of the surfaces that they met.
struct FlatMasks {
  LaneMask diffuse = 0;
  LaneMask glossy = 0;

  [[nodiscard]] LaneMask all() const { return diffuse | glossy; }
};

// Of the hits those that flat_lanes.h knows of; of a model none where they are few.
[[nodiscard]] inline FlatMasks flat_lanes_of(const Scene& scene, const HitBlock& hits,
                                             LaneMask lanes) {
  FlatMasks flat;
  for_each_lane(lanes, [&](std::uint32_t i) {
    if (!hits[i].is_hit()) return;
    const Geometry& geometry = scene.geometries[hits[i].geometry];
    if (!geometry.normals.empty()) return;
    const Material& material = scene.materials[geometry.material.index];
    if (material.model == MaterialModel::Diffuse)
      flat.diffuse |= 1u << i;
    else if (fresnel_term(material) == FresnelTerm::Schlick &&
             material.geometry == GeometryModel::SchlickGgx)
      flat.glossy |= 1u << i;
  });
  if (std::popcount(flat.diffuse) < fewest_of_vectors) flat.diffuse = 0;
  if (std::popcount(flat.glossy) < fewest_of_vectors) flat.glossy = 0;
  return flat;
}

// Calls visit(model, lanes) for the models that there are.
template <class Visit>
inline void for_each_model(const FlatMasks& flat, const Visit& visit) {
  if (flat.diffuse != 0) visit(FlatModel::Diffuse, flat.diffuse);
  if (flat.glossy != 0) visit(FlatModel::CookTorrance, flat.glossy);
}

inline void put_bsdf(const Material& material, const TextureStore& textures, std::uint32_t i,
                     BsdfLanes& bsdfs) {
  if (material.model == MaterialModel::Diffuse) {
    bsdfs.diffuse.set(i, material.diffuse.constant);
    return;
  }
  Bsdf bsdf = cook_torrance_at<false>(material, textures, {});
  bsdfs.diffuse.set(i, bsdf.diffuse);
  bsdfs.specular.set(i, bsdf.specular);
  bsdfs.f0.set(i, bsdf.f0);
  bsdfs.alpha[i] = bsdf.alpha;
}

inline void put_surface(const Scene& scene, const Hit& hit, const Ray& ray, const Rgb& throughput,
                        std::uint32_t i, FlatLanes& flat) {
  const Geometry& geometry = scene.geometries[hit.geometry];
  const auto& corners = geometry.triangles[hit.triangle];
  MetLanes& met = flat.met;
  met.corner0.set(i, geometry.positions[corners[0]]);
  met.corner1.set(i, geometry.positions[corners[1]]);
  met.corner2.set(i, geometry.positions[corners[2]]);
  met.u[i] = hit.u;
  met.v[i] = hit.v;
  met.direction.set(i, ray.direction);
  met.throughput.set(i, throughput);
  put_bsdf(scene.materials[geometry.material.index], scene.textures, i, flat.bsdfs);
}

inline void put_lamp(const Scene& scene, const StepNumbers& numbers, std::uint32_t i,
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

// A lamp that is near to its path's surface is sampled by itself.
template <FeatureSet F, class A>
[[gnu::noinline]] void add_near_lamp(const PathContext<A>& context, const Hit& hit, std::uint32_t i,
                                     PathBlock& block, LanesAfterStep& after, TileCounts& counts) {
  const Scene& scene = context.scene;
  const LampLanes& lamps = block.flat.lamps;
  const MetLanes& met = block.flat.met;
  SurfacePoint point = point_of(met, i);
  const Material& material = scene.materials[scene.geometries[hit.geometry].material.index];
  Bsdf bsdf = bsdf_at<F.models, F.textures>(material, scene.textures, texture_point_of(point),
                                            point.is_front);
  DirectLight picked = sample_direct_light<F>(
      context, lamps.light[i], Vec2f(lamps.u_x[i], lamps.u_y[i]), lamps.probability[i], point, bsdf,
      {}, point.shading.to_local(-met.direction[i]), counts);
  picked.contribution *= met.throughput[i];
  if (is_black(picked.contribution) || !is_traceable(picked.shadow_ray)) return;
  block.shadow_rays[i] = picked.shadow_ray;
  block.unshadowed[i] = picked.contribution;
  after.shadow_rays |= 1u << i;
}

// Light samples of the paths whose surfaces are in block.flat.
template <FeatureSet F, class A>
inline void light_flat_lanes(const PathContext<A>& context, const BlockNumbers& numbers,
                             const FlatMasks& flat, const HitBlock& hits, PathBlock& block,
                             LanesAfterStep& after, TileCounts& counts) {
  const Scene& scene = context.scene;
  if (!scene.light_sampler.has_table()) return;
  LampLanes& lamps = block.flat.lamps;
  for_each_lane(flat.all(),
                [&](std::uint32_t i) { put_lamp(scene, numbers.lane<F>(i), i, lamps); });
  const LaneMask near = sample_lamps(block.flat);
  for_each_model(flat, [&](FlatModel model, LaneMask lanes) {
    const LampMasks masks = weigh_lamps(model, context.options, block.flat);
    lanes &= ~near;
    counts.skipped.shadow_rays += static_cast<std::uint64_t>(std::popcount(lanes & masks.dark));
    for_each_lane(lanes & masks.shadow_rays, [&](std::uint32_t i) {
      block.shadow_rays[i] = {lamps.shadow_origin[i], lamps.shadow_direction[i],
                              shadow_segment_end};
      block.unshadowed[i] = lamps.contribution[i];
    });
    after.shadow_rays |= lanes & masks.shadow_rays;
  });
  for_each_lane(flat.all() & near, [&](std::uint32_t i) {
    add_near_lamp<F>(context, hits[i], i, block, after, counts);
  });
}

// The paths leave the surfaces in block.flat; returns those that go on.
[[nodiscard]] inline LaneMask scatter_flat_lanes(const RenderOptions& options,
                                                 const BlockNumbers& numbers, std::uint32_t bounce,
                                                 float inverse_roulette_threshold,
                                                 const FlatMasks& flat, PathBlock& block) {
  LaneMask going_on = 0;
  for_each_model(flat, [&](FlatModel model, LaneMask lanes) {
    const ScatterMasks masks =
        scatter(model, options, numbers, bounce, inverse_roulette_threshold, block.flat);
    const ScatteredLanes& scattered = block.flat.scattered;
    for_each_lane(lanes & masks.going_on, [&](std::uint32_t i) {
      PathState& path = block.paths[i];
      path.throughput = scattered.throughput[i];
      path.bsdf_pdf = scattered.pdf[i];
      path.receiving_normal = block.flat.met.normal[i];
      path.is_delta = false;
      if (set_ray(block, i, {scattered.origin[i], scattered.direction[i], infinity}))
        going_on |= 1u << i;
    });
  });
  return going_on;
}

template <FeatureSet F, class A>
inline void step_flat_lanes(const PathContext<A>& context, const BlockNumbers& numbers,
                            std::uint32_t bounce, const FlatMasks& flat, const HitBlock& hits,
                            PathBlock& block, LanesAfterStep& after, TileCounts& counts) {
  const Scene& scene = context.scene;
  for_each_lane(flat.all(), [&](std::uint32_t i) {
    const Geometry& geometry = scene.geometries[hits[i].geometry];
    const Ray& ray = block.rays[i];
    if (is_emission_met(context, geometry, bounce))
      add_emission<F>(scene, context.options, geometry, hits[i], ray.origin, ray.direction,
                      hits[i].t, block.paths[i]);
    if (bounce == 0 && context.options.aovs != 0)
      record_camera_hit<F>(scene, context.camera, ray, hits[i],
                           scene.materials[geometry.material.index], block.samples[i]);
    put_surface(scene, hits[i], ray, block.paths[i].throughput, i, block.flat);
  });
  if (bounce >= context.max_depth) return;
  find_points(block.flat.met);
  light_flat_lanes<F>(context, numbers, flat, hits, block, after, counts);
  after.going_on |= scatter_flat_lanes(context.options, numbers, bounce,
                                       context.inverse_roulette_threshold, flat, block);
}

// Other paths from the first hits of a block, in place of those that have ended (branches.h).
template <FeatureSet F, class A>
[[nodiscard]] inline LaneMask branch_flat_lanes(const PathContext<A>& context,
                                                const BlockNumbers& numbers, const FlatMasks& flat,
                                                PathBlock& block) {
  if (context.max_depth == 0) return 0;
  for_each_lane(flat.all(), [&](std::uint32_t i) {
    block.paths[i] = PathState{};
    put_surface(context.scene, block.split.hits[i], block.split.camera_rays[i], Rgb(1), i,
                block.flat);
  });
  find_points(block.flat.met);
  return scatter_flat_lanes(context.options, numbers, 0, context.inverse_roulette_threshold, flat,
                            block);
}

}  // namespace candela
