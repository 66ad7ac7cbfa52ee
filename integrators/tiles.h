// How a picture is cut: tiles over pixels, passes over samples. Neither changes a bit of the
// result.
#pragma once

#include <algorithm>
#include <cstdint>
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

// Half-open range of sample indices.
struct SampleRange {
  std::uint32_t first = 0;
  std::uint32_t end = 0;
};

// One sample first, so that an interrupted picture is whole early; then blocks of sixteen.
[[nodiscard]] inline std::vector<SampleRange> passes_of(std::uint32_t samples) {
  constexpr std::uint32_t block = 16;
  std::vector<SampleRange> passes;
  for (std::uint32_t first = 0; first < samples;) {
    const std::uint32_t end = first == 0 ? 1 : (first / block + 1) * block;
    passes.push_back({first, std::min(end, samples)});
    first = passes.back().end;
  }
  return passes;
}

}  // namespace candela
