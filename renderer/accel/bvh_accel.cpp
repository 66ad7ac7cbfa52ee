#include "renderer/accel/bvh_accel.h"

#include "renderer/accel/alpha_test.h"
#include "renderer/accel/bvh_tree.h"
#include "renderer/accel/placement.h"
#include "renderer/accel/sphere_tree.h"
#include "renderer/accel/triangle_block.h"
#include "renderer/base/floating_point_traps.h"
#include "renderer/base/parallel.h"

namespace candela {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

// Triangles in blocks of four, a block a leaf of the tree.
struct TriangleTree {
  bvh::Tree tree;
  std::vector<bvh::TriangleBlock> blocks;

  [[nodiscard]] std::size_t bytes() const {
    return tree.nodes.capacity() * sizeof(bvh::Node) +
           blocks.capacity() * sizeof(bvh::TriangleBlock);
  }
};

struct TriangleName {
  std::uint32_t geometry;
  std::uint32_t triangle;
};

void collect_triangles(const Scene& scene, GeometryHandle handle, std::vector<TriangleName>& names,
                       std::vector<Bounds3f>& boxes) {
  const Geometry& geometry = scene.geometries[handle.index];
  for (std::size_t i = 0; i < geometry.triangles.size(); ++i) {
    const std::optional<Bounds3f> box = usable_box(geometry, i);
    if (!box) continue;
    names.push_back({handle.index, static_cast<std::uint32_t>(i)});
    boxes.push_back(*box);
  }
}

bvh::TriangleBlock block_of(const Scene& scene, const bvh::Leaf& leaf,
                            const std::vector<TriangleName>& names) {
  bvh::TriangleBlock block;
  for (std::uint32_t lane = 0; lane < 4; ++lane) {
    const TriangleName name = names[leaf.items[lane < leaf.count ? lane : 0]];
    const Geometry& geometry = scene.geometries[name.geometry];
    for (std::size_t vertex = 0; vertex < 3; ++vertex)
      for (int axis = 0; axis < 3; ++axis)
        block.vertices[vertex][axis][lane] =
            geometry.positions[geometry.triangles[name.triangle][vertex]][axis];
    block.geometry[lane] = name.geometry;
    block.triangle[lane] = name.triangle;
  }
  return block;
}

TriangleTree build_triangles(const Scene& scene, const Object& object) {
  std::vector<TriangleName> names;
  std::vector<Bounds3f> boxes;
  for (const GeometryHandle geometry : object.geometries)
    collect_triangles(scene, geometry, names, boxes);
  TriangleTree made{bvh::build_tree(boxes, 4), {}};
  made.blocks.reserve(made.tree.leaves.size());
  for (const bvh::Leaf& leaf : made.tree.leaves)
    made.blocks.push_back(block_of(scene, leaf, names));
  made.tree.leaves = {};  // a leaf's index is its block's
  return made;
}

// What is placed together.
struct ObjectTrees {
  TriangleTree triangles;
  SphereTree spheres;

  [[nodiscard]] Bounds3f bounds() const {
    Bounds3f both = triangles.tree.bounds;
    both.include(spheres.tree.bounds);
    return both;
  }
  [[nodiscard]] std::size_t bytes() const { return triangles.bytes() + spheres.bytes(); }
};

ObjectTrees build_object(const Scene& scene, const Object& object) {
  return {build_triangles(scene, object), build_spheres(scene, object)};
}

struct PlacedObject {
  std::uint32_t instance;
  WorldToObject world_to_object;
};

}  // namespace

struct BvhAccel::State {
  const Scene* scene = nullptr;
  ObjectTrees world;
  std::vector<ObjectTrees> objects;
  std::vector<PlacedObject> placed;
  bvh::Tree placed_tree;  // a leaf is one item of `placed`

  [[nodiscard]] const ObjectTrees& object_of(std::uint32_t instance) const {
    return objects[scene->instances[instance].object.index];
  }

  void build() {
    world = build_object(*scene, scene->world);
    objects.resize(scene->objects.size());
    parallel_for(objects.size(),
                 [&](std::size_t i) { objects[i] = build_object(*scene, scene->objects[i]); });
    std::vector<Bounds3f> boxes;
    for (std::uint32_t i = 0; i < scene->instances.size(); ++i) {
      const Bounds3f object = object_of(i).bounds();
      const std::optional<WorldToObject> inverse = world_to_object(scene->instances[i]);
      if (!inverse || object.is_empty()) continue;
      placed.push_back({i, *inverse});
      boxes.push_back(bounds_of(scene->instances[i], object));
    }
    placed_tree = bvh::build_tree(boxes, 1);
  }

  // `ray` in the space of the triangles. Of hits at the same distance the last one tested stays.
  template <bool any_hit>
  void search(const Ray& ray, const ObjectTrees& object, const Ray& world_ray,
              std::uint32_t instance, Hit& best) const {
    search_triangles<any_hit>(ray, object.triangles, world_ray, instance, best);
    if (any_hit && best.is_hit()) return;
    if (!object.spheres.names.empty())
      search_spheres<any_hit>(*scene, object.spheres, ray, world_ray, instance, best);
  }

  template <bool any_hit>
  void search_triangles(const Ray& ray, const TriangleTree& triangles, const Ray& world_ray,
                        std::uint32_t instance, Hit& best) const {
    const bvh::ShearedRay sheared(ray);
    const auto visit = [&](std::uint32_t leaf) {
      const bvh::TriangleBlock& block = triangles.blocks[leaf];
      const bvh::BlockHits hits = bvh::intersect_block(block, sheared, best.t);
      for (int mask = hits.mask; mask != 0; mask &= mask - 1) {
        const int i = lowest_lane(mask);
        if (hits.t[i] > best.t) continue;
        if (is_transparent_at(*scene, block.geometry[i], block.triangle[i], instance, hits.u[i],
                              hits.v[i], world_ray.origin, world_ray.direction))
          continue;
        best = {hits.t[i], hits.u[i], hits.v[i], block.geometry[i], block.triangle[i], instance};
        if (any_hit) return true;
      }
      return false;
    };
    bvh::traverse<any_hit>(triangles.tree, ray, best.t, visit);
  }

  template <bool any_hit>
  [[nodiscard]] Hit search_all(const Ray& ray) const {
    Hit best;
    best.t = std::min(ray.t_max, std::numeric_limits<float>::max());
    search<any_hit>(ray, world, ray, none, best);
    if (any_hit && best.is_hit()) return best;
    bvh::traverse<any_hit>(placed_tree, ray, best.t, [&](std::uint32_t leaf) {
      const PlacedObject& p = placed[placed_tree.leaves[leaf].items[0]];
      search<any_hit>(p.world_to_object.apply(ray), object_of(p.instance), ray, p.instance, best);
      return any_hit && best.is_hit();
    });
    return best;
  }
};

BvhAccel::BvhAccel(const Scene& scene) : state_(std::make_unique<State>()) {
  state_->scene = &scene;
  state_->build();
}
BvhAccel::BvhAccel(BvhAccel&&) noexcept = default;
BvhAccel& BvhAccel::operator=(BvhAccel&&) noexcept = default;
BvhAccel::~BvhAccel() = default;

Hit BvhAccel::intersect(const Ray& ray) const {
  const FloatingPointTraps traps(Traps::Off);  // slopes of 0, see BoxRay
  const Hit hit = state_->search_all<false>(ray);
  return hit.is_hit() ? hit : Hit{};
}

bool BvhAccel::occluded(const Ray& ray) const {
  const FloatingPointTraps traps(Traps::Off);
  return state_->search_all<true>(ray).is_hit();
}

std::size_t BvhAccel::memory_bytes() const {
  std::size_t bytes = state_->world.bytes() + state_->placed.capacity() * sizeof(PlacedObject) +
                      state_->placed_tree.nodes.capacity() * sizeof(bvh::Node);
  for (const ObjectTrees& object : state_->objects) bytes += object.bytes();
  return bytes;
}

}  // namespace candela
