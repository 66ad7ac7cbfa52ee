// Directions <-> points of a latitude-longitude map, and sampling of its cells.
//
// (s, t) in [0, 1]^2: t from the file's first row, which is +y; s = 1/2 looks along -z and grows
// towards +x. Within a cell directions are uniform in solid angle (uniform in azimuth and cosine),
// so the density is constant a cell and has no pole.
#pragma once

#include "renderer/light/map_sample.h"
#include "renderer/math/constants.h"
#include "renderer/math/transcendental.h"
#include "renderer/sampling/distribution.h"

namespace candela {

// Any direction but zero.
[[nodiscard]] inline Vec2f lat_long_point(const Vec3f& d) {
  const float s = 0.5f + arc_tangent(d.x, -d.z) * (0.5f * inverse_pi);
  const float t = arc_tangent(std::sqrt(d.x * d.x + d.z * d.z), d.y) * inverse_pi;
  return {std::clamp(s, 0.0f, 1.0f), std::clamp(t, 0.0f, 1.0f)};
}

// sin^2(theta / 2) = (1 - cos(theta)) / 2 at the upper edge of a row; theta from the nearer pole,
// where 1 - cos would cancel.
[[nodiscard]] inline float lat_long_half_versine(std::uint32_t row, std::uint32_t rows) {
  const float s = sin_cos((pi / 2) * (static_cast<float>(row) / static_cast<float>(rows))).sin;
  return s * s;
}

// cos(a) - cos(b) = 2 sin((a + b) / 2) sin((b - a) / 2), times the azimuth's range.
[[nodiscard]] inline float lat_long_cell_solid_angle(const GridDistribution& grid,
                                                     std::uint32_t row) {
  const float row_angle = pi / static_cast<float>(grid.rows());
  const float centre = sin_cos((static_cast<float>(row) + 0.5f) * row_angle).sin;
  const float height = 2 * centre * sin_cos(0.5f * row_angle).sin;
  return height * (two_pi / static_cast<float>(grid.columns()));
}

[[nodiscard]] inline MapSample sample_lat_long(const GridDistribution& grid, Vec2f u) {
  const GridDistribution::Cell cell = grid.sample(u);
  const bool is_south = 2 * cell.row >= grid.rows();
  const std::uint32_t row = is_south ? grid.rows() - 1 - cell.row : cell.row;
  const float below = is_south ? 1 - cell.offset.y : cell.offset.y;
  const float upper = lat_long_half_versine(row, grid.rows());
  const float lower = lat_long_half_versine(row + 1, grid.rows());
  const float h = upper + (lower - upper) * below;
  const float cos_theta = 1 - 2 * h;
  const float sin_theta = 2 * std::sqrt(h * (1 - h));
  const float s =
      (static_cast<float>(cell.column) + cell.offset.x) / static_cast<float>(grid.columns());
  SinCos azimuth = sin_cos(two_pi * (s - 0.5f));
  Vec3f direction{sin_theta * azimuth.sin, is_south ? -cos_theta : cos_theta,
                  -sin_theta * azimuth.cos};
  return {direction, cell.probability / lat_long_cell_solid_angle(grid, cell.row)};
}

// The density of sample_lat_long() at the point of a direction.
[[nodiscard]] inline float lat_long_pdf(const GridDistribution& grid, Vec2f st) {
  const auto index = [](float x, std::uint32_t count) {
    return std::min(static_cast<std::uint32_t>(x * static_cast<float>(count)), count - 1);
  };
  const std::uint32_t row = index(st.y, grid.rows());
  const float probability = grid.probability(index(st.x, grid.columns()), row);
  return probability / lat_long_cell_solid_angle(grid, row);
}

}  // namespace candela
