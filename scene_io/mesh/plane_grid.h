// A polygon's corners as integers in a plane, where orientation is exact.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/math/vec.h"

namespace candela::mesh {

// Coordinates in [0, 2^30].
struct GridPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

// Twice the signed area of a triangle, exact: products of differences stay below 2^60.
[[nodiscard]] inline std::int64_t orientation(const GridPoint& a, const GridPoint& b,
                                              const GridPoint& c) {
  const auto difference = [](std::int32_t p, std::int32_t q) { return std::int64_t{p} - q; };
  return difference(b.x, a.x) * difference(c.y, a.y) - difference(b.y, a.y) * difference(c.x, a.x);
}

// Drops the axis along which the polygon's normal [Newell; Sutherland74] is longest, scales to
// 2^30 steps (64 times finer than float) and mirrors so that the area comes out positive.
void project_to_grid(std::span<const Vec3d> polygon, std::vector<GridPoint>& points);

}  // namespace candela::mesh
