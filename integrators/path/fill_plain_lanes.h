// From the paths of blocks to the lanes that step together (plain_lanes.h), and back.
#pragma once

#include "integrators/path/block_numbers.h"
#include "integrators/path/path_block.h"
#include "integrators/path/plain_lanes.h"
#include "integrators/path/surface_lanes.h"

namespace candela {

using PlainModelSet = std::uint32_t;
[[nodiscard]] constexpr PlainModelSet bit_of(PlainModel model) {
  return 1u << static_cast<unsigned>(model);
}

// Lanes of a block by the models of the surfaces that they met.
class PlainMasks {
 public:
  void set(PlainModel model, LaneMask lanes) {
    lanes_[static_cast<std::size_t>(model)] = static_cast<std::uint16_t>(lanes);
    models_ |= bit_of(model);
    all_ |= lanes;
  }
  [[nodiscard]] PlainModelSet models() const { return models_; }
  [[nodiscard]] LaneMask of(PlainModel model) const {
    return lanes_[static_cast<std::size_t>(model)];
  }
  [[nodiscard]] LaneMask all() const { return all_; }

 private:
  std::array<std::uint16_t, plain_models.size() + 1> lanes_{};  // by model; of None none
  PlainModelSet models_ = 0;                                    // that there are any of
  LaneMask all_ = 0;
};

// Of the hits those on plain surfaces. Model by model, of which a block mostly meets one or two:
// lanes that were put where they belong one after the other would wait for each other, as would a
// copy of what they make for what they write.
inline void find_plain_lanes(const Scene& scene, const HitBlock& hits, LaneMask lanes,
                             PlainMasks& plain) {
  plain = {};
  for (LaneMask left = lanes & hits.met; left != 0;) {
    const auto model_of = [&](std::uint32_t i) { return scene.plain_models[hits.geometry[i]]; };
    const PlainModel model = model_of(static_cast<std::uint32_t>(std::countr_zero(left)));
    LaneMask same = 0;
    for_each_lane(left, [&](std::uint32_t i) { same |= flag(model_of(i) == model) << i; });
    if (model != PlainModel::None) plain.set(model, same);
    left &= ~same;
  }
}

inline void put_normals(const Geometry& geometry, const TriangleCorners& corners,
                        std::uint32_t slot, MetLanes& met) {
  const bool has_normals = !geometry.normals.empty();
  met.has_normals[slot] = has_normals ? 1 : 0;
  if (!has_normals) return;
  met.any_has_normals = true;
  met.normal0.set(slot, geometry.normals[corners[0]]);
  met.normal1.set(slot, geometry.normals[corners[1]]);
  met.normal2.set(slot, geometry.normals[corners[2]]);
}

// Asks the memory for what the surface's maps say there, long before the first is looked at. What
// camera rays meet lies beside what their neighbours met: there it is asked for nothing.
inline void prefetch_maps(const Material& material, const TextureStore& textures, Vec2f uv) {
  for (const TextureHandle map :
       {material.diffuse.texture, material.specular.texture, material.height, material.normal_map})
    if (map) textures.prefetch(map, uv);
}

inline void put_instance(const Instance& instance, std::uint32_t slot, MetLanes& met) {
  met.instance[slot] = &instance;
  met.instanced |= 1u << slot;
}

inline void put_surface(const Scene& scene, const Geometry& geometry, const Hit& hit,
                        Coherence coherence, std::uint32_t slot, PlainLanes& lanes) {
  const auto& corners = geometry.triangles[hit.triangle];
  MetLanes& met = lanes.met;
  met.corner0.set(slot, geometry.positions[corners[0]]);
  met.corner1.set(slot, geometry.positions[corners[1]]);
  met.corner2.set(slot, geometry.positions[corners[2]]);
  if (hit.is_instanced()) [[unlikely]]
    put_instance(scene.instances[hit.instance], slot, met);
  put_normals(geometry, corners, slot, met);
  const Material& material = scene.materials[geometry.material.index];
  lanes.bsdfs.material[slot] = &material;
  lanes.bsdfs.uv[slot] =
      geometry.uvs.empty() ? SurfacePoint{}.uv : uv_of(geometry, corners, hit.u, hit.v);
  if (material.reads_uv && coherence == Coherence::Incoherent)
    prefetch_maps(material, scene.textures, lanes.bsdfs.uv[slot]);
}

// What a path's ray met, and the numbers by which it goes on.
inline void put_path(const Scene& scene, const StepNumbers& numbers, std::uint32_t bounce,
                     const Hit& hit, const Ray& ray, const PathState& path, std::uint32_t slot,
                     PlainLanes& lanes) {
  put_surface(scene, scene.geometries[hit.geometry], hit, coherence_of(bounce), slot, lanes);
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
  const bool is_flat = light.kind == LightKind::Triangle || light.kind == LightKind::Quad;
  const bool is_sphere = light.kind == LightKind::Sphere && !light.texture;
  lamps.is_other[slot] = is_flat || is_sphere ? 0 : 1;
  if (!is_flat && !is_sphere) return;
  lamps.is_sphere[slot] = is_sphere ? 1 : 0;
  lamps.faces_inwards[slot] = light.faces_inwards ? 1 : 0;
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

// Asks the memory for what put_light() reads.
inline void prefetch(const Light& light) {
  constexpr std::size_t line = 64;
  const char* begin = reinterpret_cast<const char*>(&light);
  for (std::size_t i = 0; i < sizeof(Light); i += line) __builtin_prefetch(begin + i);
}

// Deals a light sample to the path. Where lights are few, its lane often has the light already;
// where they are many, the memory is asked for it long before it is put.
inline void put_lamp(const Scene& scene, std::uint32_t cell, std::uint32_t choice, Vec2f u,
                     std::uint32_t slot, LampLanes& lamps) {
  const LightPick pick = pick_light(scene.light_sampler, cell, choice, u);
  lamps.probability[slot] = pick.probability;
  if (lamps.light[slot] != pick.light) {
    lamps.light[slot] = pick.light;
    lamps.awaited |= 1u << slot;
    prefetch(scene.lights[pick.light]);
  }
  lamps.u_x[slot] = u.x;
  lamps.u_y[slot] = u.y;
}
// All that were dealt since the last call; not before they are looked at.
inline void put_lights(const Scene& scene, LampLanes& lamps) {
  for_each_lane(lamps.awaited, [&](std::uint32_t slot) {
    put_light(scene.lights[lamps.light[slot]], slot, lamps);
  });
  lamps.awaited = 0;
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
    const Hit hit = block.split.hits[i];
    const Ray ray = block.split.camera_rays[i];
    PathState path;
    path.light_cell = light_cell_at(context.scene, ray, hit.t, 0);
    block.paths.set(i, path);
    put_path(context.scene, numbers.lane<F>(i), 0, hit, ray, path, i, lanes);
  });
  find_surfaces(model, context.scene, lanes);
  const ScatterMasks scattered = scatter(model, context.roulette, lanes);
  for_each_lane(scattered.going_on, [&](std::uint32_t i) {
    take_scattered(lanes, i, i, block);
    if (is_only_delta(model)) take_delta(lanes, i, i, block);
  });
  for_each_lane(scattered.lost, [&](std::uint32_t i) { lose_path(block, i); });
  return scattered.going_on;
}

}  // namespace candela
