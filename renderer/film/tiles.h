// How a picture is cut into tiles, which changes no bit of the result.
#pragma once

#include <algorithm>
#include <vector>

#include "renderer/film/film.h"

namespace candela {

// Squares of `size` pixels (smaller at the edges) in rows from the top.
[[nodiscard]] inline std::vector<PixelRect> tiles_of(const PixelRect& rect, int size) {
  std::vector<PixelRect> tiles;
  for (int y = rect.y0; y < rect.y1; y += size)
    for (int x = rect.x0; x < rect.x1; x += size)
      tiles.push_back({x, y, std::min(x + size, rect.x1), std::min(y + size, rect.y1)});
  return tiles;
}

}  // namespace candela
