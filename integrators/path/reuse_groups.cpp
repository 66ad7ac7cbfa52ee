#include "integrators/path/reuse_groups.h"

#include <algorithm>

#include "renderer/film/tiles.h"
#include "renderer/sampling/hash.h"

namespace candela {

std::vector<PixelPlace> pixels_to_deal(const PixelRect& square) {
  constexpr int side = 4;  // of a cell: of each colour as many as there are groups
  const auto place = [](const PixelPlace& pixel) {
    return hash_pixel(0, static_cast<std::uint32_t>(pixel.x), static_cast<std::uint32_t>(pixel.y));
  };
  std::vector<PixelPlace> pixels;
  for (const PixelRect& cell : tiles_of(square, side)) {
    const std::size_t first = pixels.size();
    for (int y = cell.y0; y < cell.y1; ++y)
      for (int x = cell.x0; x < cell.x1; ++x) pixels.push_back({x, y});
    std::ranges::sort(std::span(pixels).subspan(first), {}, place);
  }
  return pixels;
}

}  // namespace candela
