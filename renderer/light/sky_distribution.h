// Directions drawn by how much light comes from where: cells about a sky's pole, +y, whatever map
// the light is from.
//
// Rows count from +y to -y. A half of them reaches from each pole to the horizon, in even steps of
// sin(theta / 2): nearly even in angle, without a pole where cells vanish. Columns go around in
// four quarters from +x over +z, in even steps along the chord of each. So the horizon of a floor
// is a line of the square that random numbers are drawn from, and so are walls' sides: well spread
// numbers stay well spread over what a surface sees. On an equal-area map, whose horizon is a
// diamond, light samples have several times the error (docs/decisions.md). And neither a sample nor
// its density needs a sine or an arc tangent.
#pragma once

#include <algorithm>
#include <cmath>

#include "renderer/math/vec.h"
#include "renderer/sampling/distribution.h"

namespace candela {

// (1 - t, t) for a quarter's t in [0, 1], turned by the quarters before it: (x, z). In [0, 4].
[[nodiscard]] inline Vec2f sky_chord(float quarters) {
  const float whole = std::min(static_cast<float>(static_cast<std::int32_t>(quarters)), 3.0f);
  const float t = quarters - whole;
  const bool is_odd = whole == 1 || whole == 3;
  Vec2f chord = is_odd ? Vec2f{-t, 1 - t} : Vec2f{1 - t, t};
  return whole < 2 ? chord : -chord;
}
// The inverse, of any (x, z); in [0, 4].
[[nodiscard]] inline float sky_quarters(float x, float z) {
  const float reach = std::abs(x) + std::abs(z);
  if (!(reach > 0)) return 0;
  const float t = std::abs(z) / reach;
  if (x >= 0) return z >= 0 ? t : 4 - t;
  return z >= 0 ? 2 - t : 2 + t;
}

namespace sky_detail {

// Numbers of cells, by way of signed ones, which every processor's vectors convert.
[[nodiscard]] inline float as_float(std::uint32_t number) {
  return static_cast<float>(static_cast<std::int32_t>(number));
}
[[nodiscard]] inline std::uint32_t as_number(float x) {
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(x));
}

}  // namespace sky_detail

// The cell of a unit direction: its row, counted from the nearer pole, and its column.
[[nodiscard]] inline std::uint32_t sky_row_from_pole(const Vec3f& d, std::uint32_t half_rows) {
  // sin(theta / 2) / sin(pi / 4), without 1 - cos, which would cancel.
  const float height = std::sqrt((d.x * d.x + d.z * d.z) / (1 + std::abs(d.y)));
  return std::min(sky_detail::as_number(height * sky_detail::as_float(half_rows)), half_rows - 1);
}
[[nodiscard]] inline std::uint32_t sky_column(const Vec3f& d, std::uint32_t columns) {
  return std::min(
      sky_detail::as_number(sky_quarters(d.x, d.z) * (0.25f * sky_detail::as_float(columns))),
      columns - 1);
}

// A cell, and one over its solid angle as it is at one of its directions.
struct SkyPlace {
  std::uint32_t column = 0;
  std::uint32_t row = 0;
  float density = 0;
};

struct SkySample {
  Vec3f direction{0};
  float pdf = 0;  // solid angle
};

class SkyDistribution {
 public:
  SkyDistribution() = default;
  // The light of each cell; columns a multiple of four, rows of two.
  explicit SkyDistribution(GridDistribution cells) : cells_(std::move(cells)) {}

  [[nodiscard]] const GridDistribution& cells() const { return cells_; }

  // Within a cell cosines are uniform, and so is the place along a chord.
  [[nodiscard]] SkySample at(const GridDistribution::Cell& cell) const {
    const bool is_south = 2 * cell.row >= cells_.rows();
    const float row = sky_detail::as_float(is_south ? cells_.rows() - 1 - cell.row : cell.row);
    const float below = is_south ? 1 - cell.offset.y : cell.offset.y;
    const float half_rows = 0.5f * sky_detail::as_float(cells_.rows());
    // (1 - cos) / 2 = sin^2(theta / 2), 1 / 2 at the horizon.
    const float versine = 0.5f * (row * row + (2 * row + 1) * below) / (half_rows * half_rows);
    const float cos_theta = 1 - 2 * versine;
    const float sin_theta = 2 * std::sqrt(versine * (1 - versine));
    Vec2f chord = sky_chord((sky_detail::as_float(cell.column) + cell.offset.x) * 4 /
                            sky_detail::as_float(cells_.columns()));
    const float reach2 = dot(chord, chord);
    const float across = sin_theta / std::sqrt(reach2);
    return {{chord.x * across, is_south ? -cos_theta : cos_theta, chord.y * across},
            cell.probability * density(row, reach2)};
  }

  // Of a unit direction.
  [[nodiscard]] SkyPlace place_of(const Vec3f& d) const {
    const std::uint32_t row = sky_row_from_pole(d, cells_.rows() / 2);
    const std::uint32_t column = sky_column(d, cells_.columns());
    const float sin2_theta = d.x * d.x + d.z * d.z;
    const float reach = std::abs(d.x) + std::abs(d.z);
    const float reach2 = reach > 0 ? sin2_theta / (reach * reach) : 1;
    return {column, d.y < 0 ? cells_.rows() - 1 - row : row,
            density(sky_detail::as_float(row), reach2)};
  }
  // The density there of at() for cells by their light.
  [[nodiscard]] float pdf(const SkyPlace& place) const {
    return cells_.probability(place.column, place.row) * place.density;
  }

 private:
  // One over a cell's solid angle, as it is where the chord is sqrt(reach2) away: a step of the
  // cosine of (2 row + 1) / half_rows^2, times one of the azimuth of 4 / columns / reach2.
  [[nodiscard]] float density(float row, float reach2) const {
    const float half_rows = 0.5f * sky_detail::as_float(cells_.rows());
    return reach2 * sky_detail::as_float(cells_.columns()) * (half_rows * half_rows) /
           (4 * (2 * row + 1));
  }

  GridDistribution cells_;
};

// For light samples beside directions from BSDFs, which find even light as well: with a density of
// their own only for what stands out they have less to share [Karlik19]. Half of the sky's mean is
// taken off, of no cell more than nine tenths: what is seen through a window may be dark.
[[nodiscard]] SkyDistribution compensated(const SkyDistribution& sky);

}  // namespace candela
