#include "renderer/light/sky_cells.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/parallel.h"
#include "renderer/light/sky_distribution.h"

namespace candela {
namespace {

GridSize size_of(std::size_t count) {
  const auto rows = static_cast<std::uint32_t>(std::sqrt(0.5 * static_cast<double>(count)));
  const std::uint32_t even = std::max(rows - rows % 2, 2u);
  return {2 * even, even};
}

// The middle of part `part` of all that is around, of length 1.
Vec2f towards(std::uint32_t part, std::uint32_t parts) {
  return normalize(sky_chord(4 * (static_cast<float>(part) + 0.5f) / static_cast<float>(parts)));
}

// The polar angle's sine and cosine in the middle of part `part`.
Vec2f polar(std::uint32_t part, std::uint32_t parts) {
  const bool is_south = 2 * part >= parts;
  const std::uint32_t from_pole = is_south ? parts - 1 - part : part;
  const double height = 2 * (from_pole + 0.5) / parts;
  const double versine = 0.5 * height * height;
  const double cosine = 1 - 2 * versine;
  return Vec2f(2 * std::sqrt(versine * (1 - versine)), is_south ? -cosine : cosine);
}

// Of each of `cells` cells in a line, among `patches`; points lie up to 4 / pi times as far apart
// as they do on average.
std::uint32_t points_along(std::uint32_t cells, std::uint32_t patches, std::uint32_t merged) {
  const std::uint32_t usual = std::max(merged, 2u);
  const double share = static_cast<double>(patches) / cells;
  return share <= 1.5 * usual ? usual : static_cast<std::uint32_t>(std::ceil(share));
}

// The mean of so many points of each cell, along its two sides.
CellWeights gathered(GridSize size, GridSize points,
                     const std::function<double(const Vec3f&)>& luminance) {
  std::vector<Vec2f> around;
  for (std::uint32_t i = 0; i < points.columns * size.columns; ++i)
    around.push_back(towards(i, points.columns * size.columns));
  CellWeights cells(size);
  parallel_for(size.rows, [&](std::size_t i) {
    const auto row = static_cast<std::uint32_t>(i);
    for (std::uint32_t y = points.rows * row; y < points.rows * (row + 1); ++y) {
      const Vec2f sin_cos = polar(y, points.rows * size.rows);
      for (std::uint32_t x = 0; x < around.size(); ++x)
        cells.at(x / points.columns, row) +=
            luminance({sin_cos.x * around[x].x, sin_cos.y, sin_cos.x * around[x].y}) /
            (points.columns * points.rows);
    }
  });
  return cells;
}

double& cell_towards(const Vec3f& d, CellWeights& cells) {
  const auto [columns, rows] = cells.size;
  const std::uint32_t row = sky_row_from_pole(d, rows / 2);
  return cells.at(sky_column(d, columns), d.y < 0 ? rows - 1 - row : row);
}

enum class Brighten : std::uint8_t { All, DarkOnes };

// As bright at least as they are by this light alone.
void brighten(const std::function<void(const AddSkyLight&)>& lights, Brighten which,
              CellWeights& cells) {
  CellWeights fluxes(cells.size);
  lights([&](const SkyLight& light) { cell_towards(light.direction, fluxes) += light.flux; });
  parallel_for(cells.size.rows, [&](std::size_t i) {
    const auto row = static_cast<std::uint32_t>(i);
    for (std::uint32_t column = 0; column < cells.size.columns; ++column)
      if (const double flux = fluxes.at(column, row);
          flux > 0 && (which == Brighten::All || cells.at(column, row) == 0))
        cells.at(column, row) =
            std::max(cells.at(column, row), flux / sky_cell_solid_angle(cells.size, column, row));
  });
}

double largest_of_neighbours(const CellWeights& cells, std::uint32_t column, std::uint32_t row) {
  const std::uint32_t columns = cells.size.columns;
  double largest = 0;
  for (std::uint32_t y = row > 0 ? row - 1 : 0; y <= std::min(row + 1, cells.size.rows - 1); ++y)
    for (const std::uint32_t x : {column + columns - 1, column, column + 1})
      largest = std::max(largest, cells.at(x % columns, y));
  return largest;
}

// Dark cells beside bright ones get a little.
CellWeights grown(const CellWeights& cells) {
  constexpr double share = 0x1p-6;
  CellWeights result = cells;
  parallel_for(cells.size.rows, [&](std::size_t i) {
    const auto row = static_cast<std::uint32_t>(i);
    for (std::uint32_t column = 0; column < cells.size.columns; ++column)
      if (cells.at(column, row) == 0)
        result.at(column, row) = share * largest_of_neighbours(cells, column, row);
  });
  return result;
}

}  // namespace

double sky_cell_solid_angle(GridSize size, std::uint32_t column, std::uint32_t row) {
  const std::uint32_t from_pole = std::min(row, size.rows - 1 - row);
  const double cosines = 4.0 * (2 * from_pole + 1) / (static_cast<double>(size.rows) * size.rows);
  const std::uint32_t quarter = size.columns / 4;
  const auto azimuth = [&](std::uint32_t edge) {
    return std::atan2(static_cast<double>(edge), static_cast<double>(quarter - edge));
  };
  return cosines * (azimuth(column % quarter + 1) - azimuth(column % quarter));
}

GridSize sky_size(const SkyPatches& patches, std::uint32_t merged) {
  return size_of(patches.count / merged / merged);
}

CellWeights sky_cells(const SkyPatches& patches, std::uint32_t merged,
                      const SkyLuminance& luminance) {
  const GridSize size = sky_size(patches, merged);
  const GridSize points{points_along(size.columns, patches.around, merged),
                        points_along(size.rows, patches.down, merged)};
  CellWeights cells = gathered(size, points, luminance.at);
  brighten(luminance.lamps, Brighten::All, cells);
  if (std::ranges::count(cells.values, 0.0) > 0)
    brighten(luminance.all_light, Brighten::DarkOnes, cells);
  cells = grown(cells);
  for (std::uint32_t column = 0; column < cells.size.columns; ++column)
    for (std::uint32_t row = 0; row < cells.size.rows; ++row)
      cells.at(column, row) *= sky_cell_solid_angle(cells.size, column, row);
  return cells;
}

}  // namespace candela
