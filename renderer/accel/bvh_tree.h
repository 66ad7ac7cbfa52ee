// A bounding volume hierarchy over any items that have boxes, and its traversal. Each node holds
// the boxes of up to four children side by side, so that one ray is tested against four at once.
//
// The tree is a function of the boxes alone, whatever the number of threads that build it.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/math/bounds.h"
#include "renderer/math/float4.h"
#include "renderer/math/ray.h"

namespace candela::bvh {

// A child is an index into Tree::nodes or, with the top bit set, into Tree::leaves.
using Child = std::uint32_t;
constexpr Child leaf_bit = 0x80000000u;
constexpr Child no_child = 0xffffffffu;

struct alignas(64) Node {
  float planes[6][4];  // lower x, upper x, lower y, upper y, lower z, upper z; of four children
  Child children[4];   // no_child comes with an empty box, which no ray hits

  Node() {
    for (std::size_t lane = 0; lane < 4; ++lane) set_child(lane, {}, no_child);
  }
  void set_child(std::size_t lane, const Bounds3f& box, Child child) {
    for (int axis = 0; axis < 3; ++axis) {
      planes[2 * axis][lane] = box.lower[axis];
      planes[2 * axis + 1][lane] = box.upper[axis];
    }
    children[lane] = child;
  }
};

struct Leaf {
  std::uint32_t items[4];  // indices of boxes
  std::uint32_t count = 0;
};

struct Tree {
  std::vector<Node> nodes;
  std::vector<Leaf> leaves;
  Child root = no_child;
  Bounds3f bounds;
};

// At most `leaf_size` items a leaf, 1 to 4.
[[nodiscard]] Tree build_tree(const std::vector<Bounds3f>& boxes, std::uint32_t leaf_size);

// A ray prepared for boxes. Each plane is moved outwards by more than all rounding errors: 3 u r of
// this test and 6 u r of the triangle test that follows, with u = 2^-24 and r the distance of the
// farthest corner. So no ray falls between two boxes that touch [Woop13, section 4]. The origin's
// own term keeps the sum below from rounding the pad away.
struct BoxRay {
  Float4 near_origin[3];
  Float4 far_origin[3];
  Float4 inverse_direction[3];
  int near_plane[3];  // into Node::planes; the far plane's neighbour is near_plane ^ 1

  BoxRay(const Ray& ray, const Bounds3f& bounds) {
    const Vec3f farthest =
        glm::max(glm::abs(bounds.lower - ray.origin), glm::abs(bounds.upper - ray.origin));
    const float pad =
        max_component(farthest) * 0x1p-19f + max_component(glm::abs(ray.origin)) * 0x1p-23f;
    for (int axis = 0; axis < 3; ++axis) {
      const float inverse = 1 / ray.direction[axis];  // infinite for +-0
      const float outwards = std::copysign(pad, inverse);
      near_origin[axis] = broadcast(ray.origin[axis] + outwards);
      far_origin[axis] = broadcast(ray.origin[axis] - outwards);
      inverse_direction[axis] = broadcast(inverse);
      near_plane[axis] = 2 * axis + (std::signbit(inverse) ? 1 : 0);
    }
  }
};

// Which of the four boxes the ray enters before t_max, and where. 0 * infinity, of a ray within a
// plane, is NaN; min and max then keep their second operand, which ignores that plane.
struct BoxHits {
  int mask;
  Float4 entry;
};
[[nodiscard]] inline BoxHits hit_boxes(const Node& node, const BoxRay& ray, float t_max) {
  Float4 entry = broadcast(0.0f);
  Float4 exit = broadcast(t_max);
  const auto clip = [&](int axis) {  // a loop would not be unrolled
    const Float4 near_planes = load_aligned(node.planes[ray.near_plane[axis]]);
    const Float4 far_planes = load_aligned(node.planes[ray.near_plane[axis] ^ 1]);
    entry = max((near_planes - ray.near_origin[axis]) * ray.inverse_direction[axis], entry);
    exit = min((far_planes - ray.far_origin[axis]) * ray.inverse_direction[axis], exit);
  };
  clip(0);
  clip(1);
  clip(2);
  return {mask_of(entry <= exit), entry};
}

// Each level leaves at most three siblings behind; the builder makes at most 32 levels by the
// heuristic and 32 by halving.
constexpr std::size_t stack_size = 3 * 64 + 4;

struct StackEntry {
  Child child;
  float t;  // where the ray enters its box
};

// The nearest of the children that are hit, or no_child; the others go on the stack, far ones
// first. The nearest stays in registers: read back from the stack at once it would wait for the
// store.
[[nodiscard]] inline StackEntry descend(const Node& node, const BoxHits& hits, StackEntry* stack,
                                        std::size_t& size) {
  alignas(16) float entry[4];
  store_aligned(entry, hits.entry);
  int mask = hits.mask;
  if (mask == 0) return {no_child, 0};
  int lane = lowest_lane(mask);
  StackEntry nearest{node.children[lane], entry[lane]};
  const std::size_t bottom = size;
  for (mask &= mask - 1; mask != 0; mask &= mask - 1) {
    lane = lowest_lane(mask);
    StackEntry child{node.children[lane], entry[lane]};
    if (child.t < nearest.t) std::swap(child, nearest);
    std::size_t place = size++;
    for (; place > bottom && stack[place - 1].t < child.t; --place) stack[place] = stack[place - 1];
    stack[place] = child;
  }
  return nearest;
}

// The same without an order: one of the leaves, if there is one, comes first, since what it holds
// may end the walk.
[[nodiscard]] inline StackEntry descend_unordered(const Node& node, const BoxHits& hits,
                                                  StackEntry* stack, std::size_t& size) {
  int mask = hits.mask;
  if (mask == 0) return {no_child, 0};
  Child first = node.children[lowest_lane(mask)];
  for (mask &= mask - 1; mask != 0; mask &= mask - 1) {
    Child child = node.children[lowest_lane(mask)];
    if (child & leaf_bit) std::swap(child, first);
    stack[size++] = {child, 0};
  }
  return {first, 0};
}

// Calls visit(leaf index) for the leaves that the ray meets, near ones first unless any hit will
// do; visit may shorten t_max, and ends the walk by returning true.
template <bool any_hit, class Visit>
void traverse(const Tree& tree, const Ray& ray, float& t_max, const Visit& visit) {
  if (tree.root == no_child) return;
  const BoxRay box_ray(ray, tree.bounds);
  StackEntry stack[stack_size];
  std::size_t size = 0;
  StackEntry current{tree.root, 0};
  for (;;) {
    if (current.t <= t_max) {
      if (!(current.child & leaf_bit)) {
        const Node& node = tree.nodes[current.child];
        const BoxHits hits = hit_boxes(node, box_ray, t_max);
        current =
            any_hit ? descend_unordered(node, hits, stack, size) : descend(node, hits, stack, size);
        if (current.child != no_child) continue;
      } else if (visit(current.child & ~leaf_bit)) {
        return;
      }
    }
    if (size == 0) return;
    current = stack[--size];
  }
}

}  // namespace candela::bvh
