#include "scene_io/mesh/corner_tree.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace candela::mesh {
namespace {

using Triangle = std::array<GridPoint, 3>;

bool is_in(const GridPoint& p, const Triangle& triangle, bool counts_boundary) {
  const std::int64_t least = counts_boundary ? 0 : 1;
  if (orientation(triangle[0], triangle[1], p) < least) return false;
  if (orientation(triangle[1], triangle[2], p) < least) return false;
  if (orientation(triangle[2], triangle[0], p) < least) return false;
  return p != triangle[0] && p != triangle[1] && p != triangle[2];
}

// Whether the whole box lies outside edge a -> b: its corner that is farthest in does.
bool is_outside_edge(const GridPoint& a, const GridPoint& b, const GridPoint& low,
                     const GridPoint& high) {
  const GridPoint farthest_in{b.y > a.y ? low.x : high.x, b.x > a.x ? high.y : low.y};
  return orientation(a, b, farthest_in) < 0;
}

// Separating axes: those of the box, then those of the triangle.
bool is_disjoint(const Triangle& t, const GridPoint& low, const GridPoint& high) {
  if (std::max({t[0].x, t[1].x, t[2].x}) < low.x || std::min({t[0].x, t[1].x, t[2].x}) > high.x) {
    return true;
  }
  if (std::max({t[0].y, t[1].y, t[2].y}) < low.y || std::min({t[0].y, t[1].y, t[2].y}) > high.y) {
    return true;
  }
  return is_outside_edge(t[0], t[1], low, high) || is_outside_edge(t[1], t[2], low, high) ||
         is_outside_edge(t[2], t[0], low, high);
}

// Thrice the Manhattan distance from the triangle's centroid to the middle of a box, doubled.
std::int64_t distance_measure(const Triangle& t, const GridPoint& low, const GridPoint& high) {
  const std::int64_t x = 2 * (std::int64_t{t[0].x} + t[1].x + t[2].x);
  const std::int64_t y = 2 * (std::int64_t{t[0].y} + t[1].y + t[2].y);
  return std::abs(x - 3 * (std::int64_t{low.x} + high.x)) +
         std::abs(y - 3 * (std::int64_t{low.y} + high.y));
}

}  // namespace

void CornerTree::build(std::span<const GridPoint> points) {
  points_ = points;
  nodes_.clear();
  order_.resize(points.size());
  std::iota(order_.begin(), order_.end(), 0u);
  leaf_of_.assign(points.size(), none);
  is_live_.assign(points.size(), false);
  build_node(0, static_cast<std::uint32_t>(points.size()), none);
}

std::uint32_t CornerTree::build_node(std::uint32_t begin, std::uint32_t end, std::uint32_t parent) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  Node node;
  node.begin = begin;
  node.end = end;
  node.parent = parent;
  node.low = node.high = points_[order_[begin]];
  for (std::uint32_t i = begin; i < end; ++i) {
    const GridPoint& p = points_[order_[i]];
    node.low = {std::min(node.low.x, p.x), std::min(node.low.y, p.y)};
    node.high = {std::max(node.high.x, p.x), std::max(node.high.y, p.y)};
  }
  nodes_.push_back(node);
  if (end - begin <= leaf_size) {
    for (std::uint32_t i = begin; i < end; ++i) leaf_of_[order_[i]] = index;
    return index;
  }
  const bool splits_x = node.high.x - node.low.x > node.high.y - node.low.y;
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     return splits_x ? points_[a].x < points_[b].x : points_[a].y < points_[b].y;
                   });
  const std::uint32_t left = build_node(begin, middle, index);
  const std::uint32_t right = build_node(middle, end, index);
  nodes_[index].left = left;
  nodes_[index].right = right;
  return index;
}

void CornerTree::set_live(std::uint32_t corner, bool is_live) {
  if (is_live_[corner] == is_live) return;
  is_live_[corner] = is_live;
  for (std::uint32_t node = leaf_of_[corner]; node != none; node = nodes_[node].parent) {
    nodes_[node].live_count += is_live ? 1u : UINT32_MAX;  // minus one
  }
}

bool CornerTree::has_live_in_leaf(const Node& node, const Triangle& triangle,
                                  bool counts_boundary) const {
  for (std::uint32_t i = node.begin; i < node.end; ++i) {
    const std::uint32_t corner = order_[i];
    if (is_live_[corner] && is_in(points_[corner], triangle, counts_boundary)) return true;
  }
  return false;
}

bool CornerTree::has_live_in(const Triangle& triangle, bool counts_boundary,
                             std::uint64_t& work) const {
  // Each level pushes two at most, and halving 2^32 corners takes 32 levels.
  std::array<std::uint32_t, 72> stack{};
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const Node& node = nodes_[stack[--depth]];
    ++work;
    if (node.live_count == 0 || is_disjoint(triangle, node.low, node.high)) continue;
    if (node.left == none) {
      work += leaf_size;
      if (has_live_in_leaf(node, triangle, counts_boundary)) return true;
    } else {
      // The child nearer the middle first: what lies on a long side only would be looked at last.
      const Node& left = nodes_[node.left];
      const Node& right = nodes_[node.right];
      const bool is_left_nearer = distance_measure(triangle, left.low, left.high) <
                                  distance_measure(triangle, right.low, right.high);
      stack[depth++] = is_left_nearer ? node.right : node.left;
      stack[depth++] = is_left_nearer ? node.left : node.right;
    }
  }
  return false;
}

}  // namespace candela::mesh
