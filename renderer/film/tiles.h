// How a picture is cut into tiles, which changes no bit of the result.
#pragma once

#include <algorithm>
#include <vector>

#include "renderer/film/film.h"

namespace candela {

// Of the squares of `side` pixels that a picture is cut into the one with pixel x, y; smaller at
// the edges.
[[nodiscard]] inline PixelRect square_around(int x, int y, int side, int width, int height) {
  const int x0 = x - x % side, y0 = y - y % side;
  return {x0, y0, std::min(x0 + side, width), std::min(y0 + side, height)};
}

// Squares of `size` pixels (smaller at the edges) in rows from the top, cut at the multiples of
// `size` whatever the rectangle: so that few cut what pixels share (path/shared_block.h).
[[nodiscard]] inline std::vector<PixelRect> tiles_of(const PixelRect& rect, int size) {
  const auto end_of = [size](int start, int end) {
    return std::min(start - start % size + size, end);
  };
  std::vector<PixelRect> tiles;
  for (int y = rect.y0; y < rect.y1; y = end_of(y, rect.y1))
    for (int x = rect.x0; x < rect.x1; x = end_of(x, rect.x1))
      tiles.push_back({x, y, end_of(x, rect.x1), end_of(y, rect.y1)});
  return tiles;
}

}  // namespace candela
