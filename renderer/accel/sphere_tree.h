// The reference BVH over the spheres of an object.
#pragma once

#include "renderer/accel/alpha_test.h"
#include "renderer/accel/bvh_tree.h"
#include "renderer/accel/sphere_hit.h"
#include "renderer/geometry/geometry_bounds.h"

namespace candela {

struct SphereName {
  std::uint32_t geometry;
  std::uint32_t sphere;
};

struct SphereTree {
  bvh::Tree tree;
  std::vector<SphereName> names;

  [[nodiscard]] std::size_t bytes() const {
    return tree.nodes.capacity() * sizeof(bvh::Node) + tree.leaves.capacity() * sizeof(bvh::Leaf) +
           names.capacity() * sizeof(SphereName);
  }
};

[[nodiscard]] inline SphereTree build_spheres(const Scene& scene, const Object& object) {
  SphereTree made;
  std::vector<Bounds3f> boxes;
  for (const GeometryHandle handle : object.geometries) {
    const auto& spheres = scene.geometries[handle.index].spheres;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      made.names.push_back({handle.index, static_cast<std::uint32_t>(i)});
      boxes.push_back(bounds_of(spheres[i]));
    }
  }
  made.tree = bvh::build_tree(boxes, 4);
  return made;
}

// `ray` in the space of the spheres. Hits that are nearer than `best` take its place.
template <bool any_hit>
void search_spheres(const Scene& scene, const SphereTree& spheres, const Ray& ray,
                    const Ray& world_ray, std::uint32_t instance, Hit& best) {
  const auto visit = [&](std::uint32_t index) {
    const bvh::Leaf& leaf = spheres.tree.leaves[index];
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
      const auto [geometry, sphere] = spheres.names[leaf.items[i]];
      const SphereHit hit =
          intersect_sphere(scene.geometries[geometry].spheres[sphere], ray, best.t,
                           [&, g = geometry, s = sphere](float u, float v) {
                             return !is_transparent_at(scene, g, s, instance, u, v,
                                                       world_ray.origin, world_ray.direction);
                           });
      if (!hit.is_hit()) continue;
      best = {hit.t, hit.u, hit.v, geometry, sphere, instance};
      if (any_hit) return true;
    }
    return false;
  };
  bvh::traverse<any_hit>(spheres.tree, ray, best.t, visit);
}

}  // namespace candela
