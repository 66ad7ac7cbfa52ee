#include "renderer/light/luminance_map.h"

#include <atomic>

#include "renderer/base/parallel.h"
#include "renderer/light/environment.h"
#include "renderer/math/colour.h"

namespace candela {
namespace {

using environment_detail::valid_radiance;

bool is_valid(const Rgb& texel) {
  return is_finite(texel) && min_component(texel) >= 0;
}

float valid_luminance(const Rgb& texel) {
  return luminance(Rgb(valid_radiance(texel.x), valid_radiance(texel.y), valid_radiance(texel.z)));
}

// The range of texels that cell `i` of `cells` touches.
struct TexelRange {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};
TexelRange touched_texels(std::uint64_t i, std::uint64_t cells, std::uint64_t texels) {
  return {static_cast<std::uint32_t>(i * texels / cells),
          static_cast<std::uint32_t>(((i + 1) * texels + cells - 1) / cells)};
}

}  // namespace

LuminanceMap decode_luminance(const TextureStore& textures, TextureHandle texture) {
  const TextureInfo& info = textures.info(texture);
  LuminanceMap map;
  map.width = static_cast<std::uint32_t>(info.width);
  map.height = static_cast<std::uint32_t>(info.height);
  map.values.resize(std::size_t{map.width} * map.height);
  std::atomic<std::uint64_t> invalid_count = 0;
  parallel_for(map.height, [&](std::size_t y) {
    std::uint64_t invalid = 0;
    for (std::uint32_t x = 0; x < map.width; ++x) {
      const Rgb texel(textures.texel(texture, static_cast<int>(x), static_cast<int>(y)));
      invalid += is_valid(texel) ? 0 : 1;
      map.values[y * map.width + x] = valid_luminance(texel);
    }
    invalid_count += invalid;
  });
  map.invalid_count = invalid_count;
  return map;
}

// The linear interpolant's mean over [-1/2, 1/2] about a centre: 3/4 of it, 1/8 of each neighbour.
LuminanceMap bilinear_means(const LuminanceMap& map, bool columns_wrap) {
  LuminanceMap result = map;
  const std::uint32_t last_x = map.width - 1;
  const std::uint32_t last_y = map.height - 1;
  parallel_for(map.height, [&](std::size_t row) {
    const auto y = static_cast<std::uint32_t>(row);
    const std::uint32_t above = y > 0 ? y - 1 : 0;
    const std::uint32_t below = std::min(y + 1, last_y);
    const auto column_mean = [&](std::uint32_t x) {
      return 0.75f * map.at(x, y) + 0.125f * map.at(x, above) + 0.125f * map.at(x, below);
    };
    for (std::uint32_t x = 0; x < map.width; ++x) {
      const std::uint32_t left = x > 0 ? x - 1 : (columns_wrap ? last_x : 0);
      const std::uint32_t right = x < last_x ? x + 1 : (columns_wrap ? 0 : last_x);
      result.values[row * map.width + x] =
          0.75f * column_mean(x) + 0.125f * column_mean(left) + 0.125f * column_mean(right);
    }
  });
  return result;
}

double cell_mean(const LuminanceMap& map, std::uint32_t column, std::uint32_t row,
                 std::uint32_t columns, std::uint32_t rows) {
  const TexelRange xs = touched_texels(column, columns, map.width);
  const TexelRange ys = touched_texels(row, rows, map.height);
  double sum = 0;
  for (std::uint32_t y = ys.begin; y < ys.end; ++y)
    for (std::uint32_t x = xs.begin; x < xs.end; ++x) sum += static_cast<double>(map.at(x, y));
  const double count = static_cast<double>(xs.end - xs.begin) * (ys.end - ys.begin);
  return sum / count;
}

}  // namespace candela
