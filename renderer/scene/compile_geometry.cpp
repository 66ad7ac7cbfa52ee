#include "renderer/scene/compile_geometry.h"

#include <algorithm>
#include <map>
#include <utility>

#include "renderer/base/parallel.h"
#include "renderer/geometry/world_to_object.h"
#include "renderer/scene/compile_spheres.h"
#include "renderer/scene/instance_errors.h"
#include "renderer/scene/instance_range.h"
#include "renderer/scene/normalise.h"
#include "renderer/scene/object_bounds.h"
#include "renderer/scene/pick_triangles.h"
#include "renderer/scene/soup_parts.h"
#include "renderer/scene/split_triangles.h"
#include "renderer/scene/triangle_sort.h"

namespace candela {
namespace {

using description::SceneDescription;
using MeshUse = std::pair<std::uint32_t, std::uint32_t>;  // mesh, material override

// Where a mesh goes: straight into the world, or into an object that instances share.
struct Placement {
  description::MeshHandle mesh;
  description::MaterialHandle material_override;
  Transform to_normalised;
  std::vector<Geometry> geometries;
  DropCounts dropped;
};

std::uint32_t material_of(const description::Mesh& mesh, const Placement& placement,
                          std::size_t triangle) {
  if (placement.material_override) return placement.material_override.index;
  return mesh.materials[mesh.materials.size() == 1 ? 0 : triangle].index;
}

// The mesh's triangles by material.
std::map<std::uint32_t, std::vector<std::uint32_t>> by_material(const description::Mesh& mesh,
                                                                const Placement& placement) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> groups;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    groups[material_of(mesh, placement, i)].push_back(static_cast<std::uint32_t>(i));
  return groups;
}

// What the vertices of a geometry had in the mesh and have no more.
void count_dropped_attributes(const description::Mesh& mesh, const Geometry& geometry,
                              DropCounts& dropped) {
  if (!mesh.normals.empty() && geometry.normals.empty())
    dropped[DropReason::RedundantNormals] += geometry.positions.size();
  if (!mesh.uvs.empty() && geometry.uvs.empty())
    dropped[DropReason::UnreadTextureCoordinates] += geometry.positions.size();
}

void compile_mesh(const description::Mesh& mesh, const CompileOptions& options, const Scene& scene,
                  Placement& placement) {
  MeshArrays arrays = normalised_arrays(mesh, placement.to_normalised);
  const bool is_mirrored = placement.to_normalised.determinant() < 0;
  std::vector<bool> is_kept(mesh.positions.size(), false);
  for (const auto& [index, triangles] : by_material(mesh, placement)) {
    const Material& material = scene.materials[index];
    const SortedTriangles sorted =
        sort_triangles(scene, material, mesh, arrays.positions, triangles, options.decides_cutouts,
                       placement.dropped);
    for (const bool is_partial : {false, true}) {
      const auto& chosen = is_partial ? sorted.partial : sorted.opaque;
      if (chosen.empty()) continue;
      const bool reads_opacity = is_partial || !options.decides_cutouts;
      const bool reads_uv = material.reads_uv || (reads_opacity && material.opacity.texture);
      arrays.uvs = reads_uv ? mesh.uvs : std::vector<Vec2f>{};
      Geometry geometry = picked(mesh, arrays, chosen, index, is_mirrored, is_kept);
      geometry.has_cutouts = is_partial;
      geometry.reads_tangents = material.reads_tangents;
      count_dropped_attributes(mesh, geometry, placement.dropped);
      placement.geometries.push_back(std::move(geometry));
    }
  }
  const auto unused = std::count(is_kept.begin(), is_kept.end(), false);
  if (unused > 0)
    placement.dropped[DropReason::UnusedVertices] += static_cast<std::uint64_t>(unused);
}

// Each triangle of a lamp is a light, and two may be one (compile_quad_lights.h): no parts.
void compile_in_parts(const description::Mesh& mesh, const CompileOptions& options,
                      const Scene& scene, Placement& placement) {
  const std::size_t parts = part_count(mesh);
  if (parts == 1 || scene.materials[material_of(mesh, placement, 0)].is_emissive())
    return compile_mesh(mesh, options, scene, placement);
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t known = placement.geometries.size();
    compile_mesh(part_of(mesh, part), options, scene, placement);
    share_corners(placement.geometries, known);
  }
}

void compile_placement(const SceneDescription& description, const CompileOptions& options,
                       const Scene& scene, Placement& placement) {
  const description::Mesh& written = description.meshes[placement.mesh.index];
  if (written.sphere) {
    const std::uint32_t index = material_of(written, placement, 0);
    auto geometry = compile_sphere(scene, *written.sphere, placement.to_normalised, index,
                                   options.decides_cutouts, placement.dropped);
    if (geometry) placement.geometries.push_back(std::move(*geometry));
    return;
  }
  const std::optional<description::Mesh> split =
      split_large_triangles(written, placement.to_normalised);
  compile_in_parts(split ? *split : written, options, scene, placement);
}

bool is_emissive(const SceneDescription& description, const Scene& scene,
                 const description::Instance& instance) {
  const auto emits = [&](description::MaterialHandle material) {
    return material && scene.materials[material.index].is_emissive();
  };
  if (instance.material_override) return emits(instance.material_override);
  const description::Mesh& mesh = description.meshes[instance.mesh.index];
  return std::any_of(mesh.materials.begin(), mesh.materials.end(), emits);
}

MeshUse use_of(const description::Instance& instance) {
  return {instance.mesh.index, instance.material_override.index};
}

// file space -> normalised space
Transform normalising(const Normalisation& normalisation) {
  return {Mat3d(normalisation.scale), -normalisation.centre * normalisation.scale};
}

// Divided by the power of two that brings them near 1: squares of their lengths must be floats,
// however small or large the instance is.
void set_normal_columns(const Transform& t, Instance& out) {
  const std::array<Vec3d, 3> columns{t.normal({1, 0, 0}), t.normal({0, 1, 0}), t.normal({0, 0, 1})};
  double largest = 0;
  for (const Vec3d& column : columns) largest = std::max(largest, max_component(glm::abs(column)));
  int exponent = 0;
  (void)std::frexp(largest, &exponent);
  const double unit = std::ldexp(1.0, -exponent);
  out.normal_x = Vec3f(columns[0] * unit);
  out.normal_y = Vec3f(columns[1] * unit);
  out.normal_z = Vec3f(columns[2] * unit);
}

Instance compile_instance(const Transform& t, ObjectHandle object) {
  Instance out;
  out.object = object;
  out.x = Vec3f(t.linear[0]);
  out.y = Vec3f(t.linear[1]);
  out.z = Vec3f(t.linear[2]);
  out.translation = Vec3f(t.translation);
  set_normal_columns(t, out);
  return out;
}

// The placements of a scene, and for each shared one the object it becomes.
struct Plan {
  std::vector<Placement> placements;
  std::vector<ObjectHandle> object_of;  // by placement; invalid: the world
  std::vector<std::size_t> described;   // by instance of the scene: which of the description's
  std::size_t compiled = 0;             // placements
  std::size_t flattened_triangles = 0;  // of instances that can not be placed as such

  [[nodiscard]] bool has_room_for(std::size_t triangles) const {
    return flattened_triangles + triangles <= std::size_t{1} << 20;
  }
  void place_in_world(const description::Instance& instance, const Transform& to_world) {
    placements.push_back(
        {instance.mesh, instance.material_override, to_world * instance.object_to_world, {}, {}});
    object_of.emplace_back();
  }
};

struct SharedObject {
  ObjectHandle handle;
  Transform to_mesh;  // object space -> the mesh's own numbers
};

void count_meshes_without_place(const SceneDescription& description, DropCounts& dropped) {
  std::vector<bool> is_placed(description.meshes.size(), false);
  for (const description::Instance& instance : description.instances)
    is_placed[instance.mesh.index] = true;
  const auto unplaced = std::count(is_placed.begin(), is_placed.end(), false);
  if (unplaced > 0) dropped[DropReason::UnplacedMeshes] += static_cast<std::uint64_t>(unplaced);
}

Plan plan_placements(const SceneDescription& description, Scene& scene, DropCounts& dropped) {
  std::map<MeshUse, std::size_t> uses;
  for (const description::Instance& instance : description.instances) ++uses[use_of(instance)];
  count_meshes_without_place(description, dropped);

  Plan plan;
  std::map<MeshUse, SharedObject> objects;
  const Transform to_world = normalising(scene.normalisation);
  for (std::size_t i = 0; i < description.instances.size(); ++i) {
    const description::Instance& instance = description.instances[i];
    const MeshUse use = use_of(instance);
    const bool is_single = uses[use] == 1;
    if (is_single || is_emissive(description, scene, instance)) {
      ++dropped[is_single ? DropReason::SingleInstances : DropReason::LampInstances];
      plan.place_in_world(instance, to_world);
      continue;
    }
    const auto [at, is_new] = objects.try_emplace(use);
    SharedObject& object = at->second;
    if (is_new) {
      const Transform to_object =
          normalising(normalisation_of(description.meshes[instance.mesh.index]));
      object = {ObjectHandle(objects.size() - 1), inverse(to_object)};
      plan.placements.push_back({instance.mesh, instance.material_override, to_object, {}, {}});
      plan.object_of.push_back(object.handle);
    }
    scene.instances.push_back(
        compile_instance(to_world * instance.object_to_world * object.to_mesh, object.handle));
    plan.described.push_back(i);
  }
  scene.objects.resize(objects.size());
  return plan;
}

void compile_placements(const SceneDescription& description, const CompileOptions& options,
                        const Scene& scene, Plan& plan) {
  const std::size_t first = plan.compiled;
  parallel_for(plan.placements.size() - first, [&](std::size_t i) {
    compile_placement(description, options, scene, plan.placements[first + i]);
  });
  plan.compiled = plan.placements.size();
}

Bounds3f bounds_of(const std::vector<Geometry>& geometries) {
  Bounds3f bounds;
  for (const Geometry& geometry : geometries) bounds.include(bounds_of(geometry));
  return bounds;
}

// By object; of the world, too.
std::vector<Bounds3f> bounds_of_objects(const Plan& plan, std::size_t objects, Bounds3f& world) {
  std::vector<Bounds3f> bounds(objects);
  for (std::size_t i = 0; i < plan.placements.size(); ++i)
    (plan.object_of[i] ? bounds[plan.object_of[i].index] : world)
        .include(bounds_of(plan.placements[i].geometries));
  return bounds;
}

// Of those instances that do not fit, makes triangles of the world, as of single uses; past so many
// of them they are left out.
void flatten_instances(const SceneDescription& description, const auto& fits, Scene& scene,
                       Plan& plan, DropCounts& dropped) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const std::size_t described = plan.described[i];
    if (fits(i)) {
      scene.instances[kept] = scene.instances[i];
      plan.described[kept++] = described;
      continue;
    }
    const description::Instance& instance = description.instances[described];
    const std::size_t triangles = description.meshes[instance.mesh.index].triangles.size();
    if (!plan.has_room_for(triangles)) {
      ++dropped[DropReason::InstancesOutOfRange];
      continue;
    }
    plan.flattened_triangles += triangles;
    ++dropped[DropReason::InstancesOfTriangles];
    plan.place_in_world(instance, normalising(scene.normalisation));
  }
  scene.instances.resize(kept);
  plan.described.resize(kept);
}

// First those that no ray could be brought to, and grounds that had better be cut, then those that
// rays from as far as the scene goes could not be brought to.
void flatten_instances_out_of_range(const SceneDescription& description,
                                    const CompileOptions& options, Scene& scene, Plan& plan,
                                    DropCounts& dropped) {
  if (scene.instances.empty()) return;
  Bounds3f world;
  const std::vector<Bounds3f> objects = bounds_of_objects(plan, scene.objects.size(), world);
  const auto can_be_placed = [&](std::size_t i) {
    const Instance& instance = scene.instances[i];
    const Bounds3f& object = objects[instance.object.index];
    const auto mesh = description.instances[plan.described[i]].mesh;
    const std::size_t triangles = description.meshes[mesh.index].triangles.size();
    return is_placeable(instance, object) &&
           !(is_large_ground(instance, object, triangles) && plan.has_room_for(triangles));
  };
  flatten_instances(description, can_be_placed, scene, plan, dropped);
  const std::size_t first = plan.compiled;
  compile_placements(description, options, scene, plan);
  for (std::size_t i = first; i < plan.compiled; ++i)
    world.include(bounds_of(plan.placements[i].geometries));
  const double reach = reach_of_rays(scene, world, objects);
  const auto takes_rays = [&](std::size_t i) {
    const Instance& instance = scene.instances[i];
    return reach <= farthest_origin(instance) || objects[instance.object.index].is_empty();
  };
  flatten_instances(description, takes_rays, scene, plan, dropped);
  compile_placements(description, options, scene, plan);
}

// Objects of which no instance is left.
void drop_unplaced_objects(const Scene& scene, Plan& plan) {
  std::vector<bool> is_placed(scene.objects.size(), false);
  for (const Instance& instance : scene.instances) is_placed[instance.object.index] = true;
  for (std::size_t i = 0; i < plan.placements.size(); ++i) {
    if (!plan.object_of[i] || is_placed[plan.object_of[i].index]) continue;
    plan.placements[i].geometries.clear();
    plan.placements[i].dropped.clear();
  }
}

// The world's spheres of one material and visibility are one geometry.
class SpheresByKind {
 public:
  // Whether the geometry has become part of one that the scene has; else it is the scene's next.
  bool joins(const Geometry& geometry, Scene& scene) {
    if (geometry.spheres.empty()) return false;
    const auto [at, is_new] = geometries_.try_emplace(
        {geometry.material.index, geometry.has_cutouts}, scene.geometries.size());
    if (is_new) return false;
    auto& spheres = scene.geometries[at->second].spheres;
    spheres.insert(spheres.end(), geometry.spheres.begin(), geometry.spheres.end());
    return true;
  }

 private:
  std::map<std::pair<std::uint32_t, bool>, std::size_t> geometries_;
};

}  // namespace

void compile_geometry(const SceneDescription& description, const CompileOptions& options,
                      Scene& scene, DropCounts& dropped) {
  Plan plan = plan_placements(description, scene, dropped);
  compile_placements(description, options, scene, plan);
  flatten_instances_out_of_range(description, options, scene, plan, dropped);
  drop_unplaced_objects(scene, plan);
  SpheresByKind worlds_spheres;
  for (std::size_t i = 0; i < plan.placements.size(); ++i) {
    Placement& placement = plan.placements[i];
    for (const auto& [reason, count] : placement.dropped) dropped[reason] += count;
    Object& target = plan.object_of[i] ? scene.objects[plan.object_of[i].index] : scene.world;
    for (Geometry& geometry : placement.geometries) {
      if (!plan.object_of[i] && worlds_spheres.joins(geometry, scene)) continue;
      target.geometries.emplace_back(scene.geometries.size());
      scene.geometries.push_back(std::move(geometry));
    }
  }
  const std::vector<Bounds3f> objects = bounds_of_objects(scene);
  for (Instance& instance : scene.instances) set_errors(instance, objects[instance.object.index]);
}

Bounds3f bounds_of(const Scene& scene) {
  Bounds3f bounds = bounds_of(scene, scene.world);
  const std::vector<Bounds3f> objects = bounds_of_objects(scene);
  for (const Instance& instance : scene.instances) {
    const Bounds3f& box = objects[instance.object.index];
    if (!box.is_empty()) bounds.include(bounds_of(instance, box));
  }
  return bounds;
}

}  // namespace candela
