#include "renderer/light/luminance_rows.h"

#include <algorithm>

#include "renderer/light/image_radiance.h"
#include "renderer/math/colour.h"

namespace candela {
namespace {

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
  map.values.resize(std::size_t{rows.count()} * map.width);
  float* value = map.values.data();
  for (std::uint32_t y = rows.begin; y < rows.end; ++y)
    for (const Vec4f& texel : textures.texels(texture, static_cast<int>(y)))
      *value++ = luminance(valid_radiance(texel));
  return map;
}

}  // namespace

// The linear interpolant's mean over [-1/2, 1/2] about a centre: 3/4 of it, 1/8 of each neighbour.
LuminanceRows filtered_luminance(const TextureStore& textures, TextureHandle texture, RowRange rows,
                                 bool columns_wrap) {
  const auto height = static_cast<std::uint32_t>(textures.info(texture).height);
  const RowRange needed{rows.begin > 0 ? rows.begin - 1 : 0, std::min(rows.end + 1, height)};
  const LuminanceRows map = decode(textures, texture, needed);
  LuminanceRows result{map.width, rows, {}};
  result.values.resize(std::size_t{rows.count()} * map.width);
  std::vector<float> means(map.width + 2);  // of the columns, and beyond both ends
  for (std::uint32_t y = rows.begin; y < rows.end; ++y) {
    const float* const here = map.row(y);
    const float* const above = map.row(std::max(y, needed.begin + 1) - 1);
    const float* const below = map.row(std::min(y + 1, needed.end - 1));
    for (std::uint32_t x = 0; x < map.width; ++x)
      means[x + 1] = 0.75f * here[x] + 0.125f * above[x] + 0.125f * below[x];
    means.front() = columns_wrap ? means[map.width] : means[1];
    means.back() = columns_wrap ? means[1] : means[map.width];
    float* const values = result.values.data() + std::size_t{y - rows.begin} * map.width;
    for (std::uint32_t x = 0; x < map.width; ++x)
      values[x] = 0.75f * means[x + 1] + 0.125f * means[x] + 0.125f * means[x + 2];
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
