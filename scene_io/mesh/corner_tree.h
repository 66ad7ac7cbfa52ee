// A k-d tree over a polygon's corners of which some count ("live"): does any live one lie in a
// triangle? Built once over all corners; corners come and go by counters up the tree.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scene_io/mesh/plane_grid.h"

namespace candela::mesh {

class CornerTree {
 public:
  // Keeps `points`, which must stay where they are. No corner is live.
  void build(std::span<const GridPoint> points);
  void set_live(std::uint32_t corner, bool is_live);

  // Whether a live corner lies within the counter-clockwise triangle: in its interior or, if
  // `counts_boundary`, on its edges; corners at the place of one of its vertices never count.
  // Adds what it looked at to `work`.
  [[nodiscard]] bool has_live_in(const std::array<GridPoint, 3>& triangle, bool counts_boundary,
                                 std::uint64_t& work) const;

 private:
  static constexpr std::uint32_t none = UINT32_MAX;
  static constexpr std::uint32_t leaf_size = 8;
  struct Node {
    GridPoint low, high;  // box of all its corners
    std::uint32_t begin = 0, end = 0;
    std::uint32_t left = none, right = none;  // none: a leaf
    std::uint32_t parent = none;
    std::uint32_t live_count = 0;
  };

  std::uint32_t build_node(std::uint32_t begin, std::uint32_t end, std::uint32_t parent);
  [[nodiscard]] bool has_live_in_leaf(const Node& node, const std::array<GridPoint, 3>& triangle,
                                      bool counts_boundary) const;

  std::span<const GridPoint> points_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;    // corners, leaf by leaf
  std::vector<std::uint32_t> leaf_of_;  // corner -> node
  std::vector<bool> is_live_;
};

}  // namespace candela::mesh
