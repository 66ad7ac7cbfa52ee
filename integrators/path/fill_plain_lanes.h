// From the paths of blocks to the lanes that step together (plain_lanes.h), and back.
#pragma once

#include "integrators/path/block_numbers.h"
#include "integrators/path/path_block.h"
#include "integrators/path/plain_lanes.h"

namespace candela {

// Lanes of a block by the models of the surfaces that they met.
class PlainMasks {
 public:
  void add(PlainModel model, std::uint32_t lane) {
    std::uint16_t& of_model = lanes_[static_cast<std::size_t>(model)];
    of_model = static_cast<std::uint16_t>(of_model | 1u << lane);
  }
  [[nodiscard]] LaneMask of(PlainModel model) const {
    return lanes_[static_cast<std::size_t>(model)];
  }
  [[nodiscard]] LaneMask all() const {
    LaneMask lanes = 0;
    for (const PlainModel model : plain_models) lanes |= of(model);
    return lanes;
  }

 private:
  std::array<std::uint16_t, plain_models.size() + 1> lanes_{};  // by model, None among them
};

// Of the hits those on plain surfaces that stand where the scene says.
[[nodiscard]] inline PlainMasks plain_lanes_of(const Scene& scene, const HitBlock& hits,
                                               LaneMask lanes) {
  PlainMasks plain;
  for_each_lane(lanes & hits.met & ~hits.instanced,
                [&](std::uint32_t i) { plain.add(scene.plain_models[hits.geometry[i]], i); });
  return plain;
}

[[nodiscard]] inline TexturePoint texture_point_of(const PlainLanes& lanes, std::uint32_t slot) {
  return {lanes.bsdfs.uv[slot], lanes.met.position[slot], lanes.met.normal[slot]};
}

// `cos_o`: at the shading normal.
inline void put_coat(const Bsdf& bsdf, float cos_o, std::uint32_t slot, BsdfLanes& bsdfs) {
  bsdfs.diffuse.set(slot, bsdf.diffuse);
  bsdfs.alpha[slot] = bsdf.alpha;
  bsdfs.coat_eta[slot] = bsdf.coat->eta();
  bsdfs.transmittance_o[slot] = bsdf.coat->transmittance(cos_o, bsdf.alpha);
  bsdfs.mean_transmittance[slot] = bsdf.coat->mean_transmittance(bsdf.alpha);
}

inline void put_bsdf(PlainModel model, const TextureStore& textures, std::uint32_t slot,
                     PlainLanes& lanes) {
  BsdfLanes& bsdfs = lanes.bsdfs;
  const Material& material = *bsdfs.material[slot];
  const TexturePoint at = texture_point_of(lanes, slot);
  if (model == PlainModel::Diffuse || model == PlainModel::Mirror) {
    bsdfs.diffuse.set(slot, colour_at(material.diffuse, textures, at));
    return;
  }
  if (model == PlainModel::Conductor) {
    const MetalIndex metal = metal_index_at(material, textures, at);
    bsdfs.eta.set(slot, metal.eta);
    bsdfs.k.set(slot, metal.k);
    bsdfs.alpha[slot] = ggx_width(material.roughness.constant);
    return;
  }
  if (model == PlainModel::CoatedDiffuse) {
    put_coat(coated_diffuse_at(material, textures, at),
             dot(-lanes.met.direction[slot], lanes.met.shading_normal[slot]), slot, bsdfs);
    return;
  }
  if (model == PlainModel::Glass) {
    const Bsdf glass = dielectric_at(material, textures, at, lanes.met.is_front[slot] != 0);
    bsdfs.eta.set(slot, glass.eta);
    bsdfs.transmittance.set(slot, glass.transmittance);
    return;
  }
  Bsdf bsdf = model == PlainModel::Lab ? lab_at(material, textures, at)
                                       : cook_torrance_at(material, textures, at);
  bsdfs.diffuse.set(slot, bsdf.diffuse);
  bsdfs.specular.set(slot, bsdf.specular);
  bsdfs.f0.set(slot, bsdf.f0);
  bsdfs.alpha[slot] = bsdf.alpha;
}
// What textures say is looked up one path after the other, once it is known where they are.
inline void put_bsdfs(PlainModel model, const TextureStore& textures, PlainLanes& lanes) {
  for_each_lane(lanes.filled, [&](std::uint32_t slot) { put_bsdf(model, textures, slot, lanes); });
}

// Likewise, where surfaces have bumps.
inline void put_bumps(const Scene& scene, PlainLanes& lanes) {
  MetLanes& met = lanes.met;
  for_each_lane(lanes.filled, [&](std::uint32_t slot) {
    const Material& material = *lanes.bsdfs.material[slot];
    if (!has_bump(material)) return;
    const Geometry& geometry = scene.geometries[met.geometry[slot]];
    const Float4 corner0 = to_lanes(met.corner0[slot]);
    SurfacePoint point;
    if (!geometry.uvs.empty())
      set_tangents(geometry, geometry.triangles[met.triangle[slot]],
                   to_lanes(met.corner1[slot]) - corner0, to_lanes(met.corner2[slot]) - corner0,
                   point);
    met.front_normal.set(slot,
                         shading_normal_at(material, scene.textures, texture_point_of(lanes, slot),
                                           met.front_normal[slot], point.dpdu, point.dpdv));
    met.is_flat[slot] = 0;
    met.all_are_flat = false;
  });
}

inline void put_normals(const Geometry& geometry, const std::array<std::uint32_t, 3>& corners,
                        std::uint32_t slot, MetLanes& met) {
  const bool has_normals = !geometry.normals.empty();
  met.has_normals[slot] = has_normals ? 1 : 0;
  if (!has_normals) return;
  met.any_has_normals = true;
  met.normal0.set(slot, geometry.normals[corners[0]]);
  met.normal1.set(slot, geometry.normals[corners[1]]);
  met.normal2.set(slot, geometry.normals[corners[2]]);
}

// Asks the memory for what the surface's maps say there, long before the first is looked at.
inline void prefetch_maps(const Material& material, const TextureStore& textures, Vec2f uv) {
  for (const TextureHandle map :
       {material.diffuse.texture, material.specular.texture, material.height, material.normal_map})
    if (map) textures.prefetch(map, uv);
}

inline void put_surface(const Scene& scene, const Geometry& geometry, std::uint32_t triangle,
                        float u, float v, std::uint32_t slot, PlainLanes& lanes) {
  const auto& corners = geometry.triangles[triangle];
  MetLanes& met = lanes.met;
  met.corner0.set(slot, geometry.positions[corners[0]]);
  met.corner1.set(slot, geometry.positions[corners[1]]);
  met.corner2.set(slot, geometry.positions[corners[2]]);
  put_normals(geometry, corners, slot, met);
  const Material& material = scene.materials[geometry.material.index];
  lanes.bsdfs.material[slot] = &material;
  lanes.bsdfs.uv[slot] = geometry.uvs.empty() ? SurfacePoint{}.uv : uv_of(geometry, corners, u, v);
  if (material.reads_uv) prefetch_maps(material, scene.textures, lanes.bsdfs.uv[slot]);
}

// What a path's ray met, and the numbers by which it goes on.
inline void put_path(const Scene& scene, const StepNumbers& numbers, std::uint32_t bounce,
                     const Hit& hit, const Ray& ray, const PathState& path, std::uint32_t slot,
                     PlainLanes& lanes) {
  put_surface(scene, scene.geometries[hit.geometry], hit.triangle, hit.u, hit.v, slot, lanes);
  MetLanes& met = lanes.met;
  met.geometry[slot] = hit.geometry;
  met.triangle[slot] = hit.triangle;
  met.u[slot] = hit.u;
  met.v[slot] = hit.v;
  met.direction.set(slot, ray.direction);
  met.throughput.set(slot, path.throughput);
  met.roulette_scale[slot] = path.roulette_scale;
  ScatteredLanes& scattered = lanes.scattered;
  scattered.bounce[slot] = bounce;
  scattered.lobe[slot] = numbers.lobe;
  scattered.direction_x[slot] = numbers.direction.x;
  scattered.direction_y[slot] = numbers.direction.y;
  scattered.roulette[slot] = numbers.roulette;
  lanes.filled |= 1u << slot;
}

inline void put_light(const Light& light, std::uint32_t slot, LampLanes& lamps) {
  const bool is_surface = (light_kind_bit(light.kind) & surface_light_kinds) != 0;
  lamps.is_other[slot] = is_surface ? 0 : 1;
  if (!is_surface) return;
  lamps.is_triangle[slot] = light.kind == LightKind::Triangle ? 1 : 0;
  lamps.emits_both_sides[slot] = light.emits_both_sides ? 1 : 0;
  lamps.position.set(slot, light.position);
  lamps.edge1.set(slot, light.edge1);
  lamps.edge2.set(slot, light.edge2);
  lamps.normal.set(slot, light.normal);
  lamps.emission.set(slot, light.emission);
  lamps.area[slot] = light.area;
  lamps.offset[slot] = light.offset;
  lamps.near_distance2[slot] = light.near_distance2;
}

// Deals a light sample to the path. Where lights are few, its lane often has the light already.
inline void put_lamp(const Scene& scene, std::uint32_t choice, Vec2f u, std::uint32_t slot,
                     LampLanes& lamps) {
  const LightPick pick = pick_light(scene.light_sampler, choice, u);
  if (lamps.light[slot] != pick.light) {
    lamps.light[slot] = pick.light;
    lamps.probability[slot] = pick.probability;
    put_light(scene.lights[pick.light], slot, lamps);
  }
  lamps.u_x[slot] = u.x;
  lamps.u_y[slot] = u.y;
}

// The path in lane i of the block goes on.
inline void take_scattered(const PlainLanes& lanes, std::uint32_t slot, std::uint32_t i,
                           PathBlock& block) {
  PathLanes& paths = block.paths;
  paths.throughput.set(i, lanes.scattered.throughput[slot]);
  paths.bsdf_pdf[i] = lanes.scattered.pdf[slot];
  paths.receiving_normal.set(i, lanes.met.shading_normal[slot]);
  paths.is_delta[i] = 0;
  block.rays.set(i, {lanes.scattered.origin[slot], lanes.scattered.direction[slot], infinity});
}

// Then, where it left by a delta lobe.
inline void take_delta(const PlainLanes& lanes, std::uint32_t slot, std::uint32_t i,
                       PathBlock& block) {
  block.paths.is_delta[i] = 1;
  block.paths.roulette_scale[i] = lanes.scattered.roulette_scale[slot];
}

// The surfaces, once all paths are put.
inline void find_surfaces(PlainModel model, const Scene& scene, PlainLanes& lanes) {
  find_points(lanes);
  if (scene.features.bump) put_bumps(scene, lanes);
  find_frames(lanes);
  put_bsdfs(model, scene.textures, lanes);
}

// Other paths from the first hits of a block in place of those that have ended (branches.h);
// returns the lanes of those that go on.
template <FeatureSet F, class A>
[[nodiscard]] inline LaneMask branch_plain_lanes(const PathContext<A>& context,
                                                 const BlockNumbers& numbers, PlainModel model,
                                                 LaneMask of_block, PathBlock& block,
                                                 PlainLanes& lanes) {
  if (context.max_depth == 0 || of_block == 0) return 0;
  lanes.clear();
  for_each_lane(of_block, [&](std::uint32_t i) {
    block.paths.set(i, PathState{});
    put_path(context.scene, numbers.lane<F>(i), 0, block.split.hits[i], block.split.camera_rays[i],
             PathState{}, i, lanes);
  });
  find_surfaces(model, context.scene, lanes);
  const ScatterMasks scattered = scatter(model, context.inverse_roulette_threshold, lanes);
  for_each_lane(scattered.going_on, [&](std::uint32_t i) {
    take_scattered(lanes, i, i, block);
    if (is_only_delta(model)) take_delta(lanes, i, i, block);
  });
  for_each_lane(scattered.lost, [&](std::uint32_t i) { lose_path(block, i); });
  return scattered.going_on;
}

}  // namespace candela
