// Polygons of a mesh file -> triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/math/vec.h"

namespace candela::mesh {

// n - 2 triangles, each three indices into `polygon`, in the polygon's own orientation, for n >= 3.
//
// Quads take the shorter diagonal that lies inside. Larger ones are projected along the dominant
// axis of their normal (Newell), snapped to a grid of 2^30 (finer than float, so that orientation
// is exact in 64 bits) and cut by ear clipping; a k-d tree over the reflex corners finds what is in
// the way. Simple polygons, and those with holes on bridges, are covered exactly once. Anything
// else (crossing itself, collinear, all corners equal) still ends in n - 2 triangles, with a
// bounded amount of work.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3d> polygon);

// The same, appended to `triangles`; `triangulate` for one polygon after another.
void append_triangles(std::span<const Vec3d> polygon,
                      std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace candela::mesh
