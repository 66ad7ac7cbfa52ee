// Polygons of a mesh file -> triangles.
//
// A polygon of n >= 3 corners becomes n - 2 triangles in its own orientation. Quads take the
// shorter diagonal of those that lie inside; where two opposite edges of one cross (a bow), its
// corners are taken in the order in which they do not, in the orientation of the first three.
// Larger ones are cut by ear clipping [Meisters75, theorem 1] in rounds that leave every other
// corner alone, so that triangles stay compact; a k-d tree over the corners that are not convex
// finds what is in an ear's way. Simple polygons, and those with holes on bridges, are covered
// exactly once. What is neither (crossing itself, collinear, all corners equal) ends in n - 2
// triangles too, after a bounded amount of work.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/math/vec.h"
#include "scene_io/mesh/corner_tree.h"
#include "scene_io/mesh/plane_grid.h"

namespace candela::mesh {

using IndexTriangle = std::array<std::uint32_t, 3>;

// Keeps its memory from one polygon to the next.
class Triangulator {
 public:
  // Triangles of indices into `polygon`, which are valid until the next call; none for fewer than
  // three corners.
  [[nodiscard]] std::span<const IndexTriangle> triangulate(std::span<const Vec3d> polygon);
  // Whether the last polygon was a quad whose edges cross.
  [[nodiscard]] bool was_bow() const { return was_bow_; }

 private:
  // How much may be in the way of an ear.
  enum class Strictness : std::uint8_t { Boundary, Interior };

  void split_quad(std::span<const Vec3d> polygon);
  void split_odd_quad(bool is_02_shorter);
  void clip_ears();
  void start();
  void clip_round();
  void clip_stuck();
  void clip(std::uint32_t corner);
  void classify(std::uint32_t corner);
  void touch(std::uint32_t corner);
  void finish_as_fan();
  // Whether all the work that the polygon is worth has been done.
  [[nodiscard]] bool is_spent() const;
  [[nodiscard]] bool is_ear(std::uint32_t corner, Strictness strictness);
  [[nodiscard]] bool may_clip_stuck(std::uint32_t corner);
  [[nodiscard]] std::int64_t turn_at(std::uint32_t corner) const;
  void emit(std::uint32_t a, std::uint32_t b, std::uint32_t c) { triangles_.push_back({a, b, c}); }

  std::vector<IndexTriangle> triangles_;
  std::vector<GridPoint> points_;
  std::vector<std::uint32_t> previous_, next_;  // the ring of what is left
  std::vector<std::uint32_t> round_, next_round_;
  std::vector<std::uint32_t> touched_in_;  // the round in which a corner's ring neighbour went
  std::vector<bool> is_queued_;
  CornerTree blocking_;
  std::uint32_t remaining_ = 0;
  std::uint32_t round_number_ = 0;
  std::uint32_t stuck_at_ = 0;
  std::uint64_t work_ = 0;
  bool was_bow_ = false;
};

}  // namespace candela::mesh
