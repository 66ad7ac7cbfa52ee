#include "renderer/light/luminance_rows.h"

#include <algorithm>

#include "renderer/light/image_radiance.h"
#include "renderer/math/colour.h"

namespace candela {
namespace {

bool is_valid(const Rgb& texel) {
  return is_finite(texel) && min_component(texel) >= 0;
}

float valid_luminance(const Rgb& texel) {
  return luminance(valid_radiance(Vec4f(texel, 1)));
}

std::uint32_t first_touched(std::uint64_t cell, std::uint64_t cells, std::uint64_t texels) {
  return static_cast<std::uint32_t>(cell * texels / cells);
}
std::uint32_t end_touched(std::uint64_t cell, std::uint64_t cells, std::uint64_t texels) {
  return static_cast<std::uint32_t>(((cell + 1) * texels + cells - 1) / cells);
}

LuminanceRows decode(const TextureStore& textures, TextureHandle texture, RowRange rows) {
  LuminanceRows map;
  map.width = static_cast<std::uint32_t>(textures.info(texture).width);
  map.rows = rows;
  map.values.reserve(std::size_t{rows.count()} * map.width);
  for (std::uint32_t y = rows.begin; y < rows.end; ++y) {
    std::uint32_t& invalid = map.invalid_counts.emplace_back(0);
    for (std::uint32_t x = 0; x < map.width; ++x) {
      const Rgb texel(textures.texel(texture, static_cast<int>(x), static_cast<int>(y)));
      invalid += is_valid(texel) ? 0 : 1;
      map.values.push_back(valid_luminance(texel));
    }
  }
  return map;
}

}  // namespace

// The linear interpolant's mean over [-1/2, 1/2] about a centre: 3/4 of it, 1/8 of each neighbour.
LuminanceRows filtered_luminance(const TextureStore& textures, TextureHandle texture, RowRange rows,
                                 bool columns_wrap) {
  const auto height = static_cast<std::uint32_t>(textures.info(texture).height);
  const RowRange needed{rows.begin > 0 ? rows.begin - 1 : 0, std::min(rows.end + 1, height)};
  const LuminanceRows map = decode(textures, texture, needed);
  const std::uint32_t last_x = map.width - 1;
  LuminanceRows result{map.width, rows, {}, {}};
  result.values.reserve(std::size_t{rows.count()} * map.width);
  for (std::uint32_t y = rows.begin; y < rows.end; ++y) {
    result.invalid_counts.push_back(map.invalid_counts[y - needed.begin]);
    const std::uint32_t above = std::max(y, needed.begin + 1) - 1;
    const std::uint32_t below = std::min(y + 1, needed.end - 1);
    const auto column_mean = [&](std::uint32_t x) {
      return 0.75f * map.at(x, y) + 0.125f * map.at(x, above) + 0.125f * map.at(x, below);
    };
    for (std::uint32_t x = 0; x < map.width; ++x) {
      const std::uint32_t left = x > 0 ? x - 1 : (columns_wrap ? last_x : 0);
      const std::uint32_t right = x < last_x ? x + 1 : (columns_wrap ? 0 : last_x);
      result.values.push_back(0.75f * column_mean(x) + 0.125f * column_mean(left) +
                              0.125f * column_mean(right));
    }
  }
  return result;
}

RowRange touched_rows(RowRange cells, std::uint32_t cell_rows, std::uint32_t texel_rows) {
  return {first_touched(cells.begin, cell_rows, texel_rows),
          end_touched(cells.end - 1, cell_rows, texel_rows)};
}

double cell_mean(const LuminanceRows& map, RowRange texels, std::uint32_t column,
                 std::uint32_t columns) {
  const std::uint32_t begin = first_touched(column, columns, map.width);
  const std::uint32_t end = end_touched(column, columns, map.width);
  double sum = 0;
  for (std::uint32_t y = texels.begin; y < texels.end; ++y)
    for (std::uint32_t x = begin; x < end; ++x) sum += static_cast<double>(map.at(x, y));
  return sum / (static_cast<double>(end - begin) * texels.count());
}

}  // namespace candela
