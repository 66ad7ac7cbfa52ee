// Directions <-> points of a cube map, and sampling of its cells.
//
// Faces count 0..5 as +X -X +Y -Y +Z -Z; (s, t) in [0, 1]^2 as in [OpenGL46, table 8.19], t from
// the file's first row. A grid for sampling has the six faces' rows one below the other.
#pragma once

#include "renderer/light/map_sample.h"
#include "renderer/sampling/distribution.h"

namespace candela {

struct CubePoint {
  int face = 0;
  Vec2f st{0.5f};
  float major = 1;  // |component| that decided the face
};

// Any direction but zero.
[[nodiscard]] inline CubePoint cube_point(const Vec3f& d) {
  Vec3f a = glm::abs(d);
  const auto point = [](int face, float s, float t, float major) {
    const float half = 0.5f / major;
    return CubePoint{face, {s * half + 0.5f, t * half + 0.5f}, major};
  };
  if (a.x >= a.y && a.x >= a.z)
    return d.x > 0 ? point(0, -d.z, -d.y, a.x) : point(1, d.z, -d.y, a.x);
  if (a.y >= a.z) return d.y > 0 ? point(2, d.x, d.z, a.y) : point(3, d.x, -d.z, a.y);
  return d.z > 0 ? point(4, d.x, -d.y, a.z) : point(5, -d.x, -d.y, a.z);
}

// The inverse: not normalised, the component along the face's axis is +-1.
[[nodiscard]] inline Vec3f cube_direction(int face, Vec2f st) {
  const float s = 2 * st.x - 1;
  const float t = 2 * st.y - 1;
  switch (face) {
    case 0:
      return {1, -t, -s};
    case 1:
      return {-1, -t, s};
    case 2:
      return {s, 1, t};
    case 3:
      return {s, -1, -t};
    case 4:
      return {s, -t, 1};
    default:
      return {-s, -t, -1};
  }
}

// Points uniform within a cell of area A on the face at distance 1 have the density
// r^3 / A in solid angle, with r their distance from the centre.
[[nodiscard]] inline float cube_cells_over_face_area(const GridDistribution& grid) {
  return static_cast<float>(grid.columns()) * static_cast<float>(grid.rows()) / 24.0f;
}

[[nodiscard]] inline MapSample sample_cube(const GridDistribution& grid, Vec2f u) {
  const GridDistribution::Cell cell = grid.sample(u);
  const std::uint32_t rows = grid.rows() / 6;
  const std::uint32_t face = cell.row / rows;
  Vec2f st{(static_cast<float>(cell.column) + cell.offset.x) / static_cast<float>(grid.columns()),
           (static_cast<float>(cell.row - face * rows) + cell.offset.y) / static_cast<float>(rows)};
  Vec3f d = cube_direction(static_cast<int>(face), st);
  const float r2 = dot(d, d);
  const float r = std::sqrt(r2);
  return {d / r, cell.probability * cube_cells_over_face_area(grid) * (r2 * r)};
}

// The density of sample_cube() at the point of a unit direction.
[[nodiscard]] inline float cube_pdf(const GridDistribution& grid, const CubePoint& point) {
  const std::uint32_t rows = grid.rows() / 6;
  const auto index = [](float x, std::uint32_t count) {
    return std::min(static_cast<std::uint32_t>(x * static_cast<float>(count)), count - 1);
  };
  const std::uint32_t row = static_cast<std::uint32_t>(point.face) * rows + index(point.st.y, rows);
  const float probability = grid.probability(index(point.st.x, grid.columns()), row);
  const float r = 1 / point.major;
  return probability * cube_cells_over_face_area(grid) * (r * r * r);
}

}  // namespace candela
