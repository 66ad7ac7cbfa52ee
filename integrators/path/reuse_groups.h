// Which pixels share what their paths find: those of an aligned square that lie apart by the same
// step each way. Neighbours, by which errors are told and samples dealt out (renderer/film), share
// nothing, nor do pixels of different colours on a chessboard (adaptive sampling's pilot).
#pragma once

#include <algorithm>

#include "integrators/tile_pass.h"

namespace candela {

inline constexpr int reuse_side = 4;  // pixels of a group, each way
inline constexpr int reuse_step = 4;  // from one to the next
inline constexpr int reuse_group_size = reuse_side * reuse_side;
static_assert(reuse_step % 2 == 0);  // the same colour

// Whether the pixels of a pass share.
[[nodiscard]] inline bool reuses_paths(const TilePass& pass) {
  return pass.plan.reuses_paths && pass.observer == nullptr;
}

// Where the aligned square begins that has a pixel, each way.
inline constexpr int reuse_square = reuse_side * reuse_step;
[[nodiscard]] inline int reuse_square_begin(int pixel) {
  return pixel - pixel % reuse_square;
}

// Of a pixel, among those of its square.
[[nodiscard]] inline int reuse_group_of(int x, int y) {
  return y % reuse_step * reuse_step + x % reuse_step;
}

// Calls visit(x, y) for the pixels of the squares that have one in the tile, of the trial's group
// where there is one, and end() after those of each group.
template <class Visit, class End>
inline void for_each_group(const TilePass& pass, int width, int height, const Visit& visit,
                           const End& end) {
  constexpr int square = reuse_square;
  const PixelRect& tile = pass.tile;
  for (int y0 = reuse_square_begin(tile.y0); y0 < tile.y1; y0 += square)
    for (int x0 = reuse_square_begin(tile.x0); x0 < tile.x1; x0 += square)
      for (int i = 0; i < reuse_step * reuse_step; ++i) {
        if (pass.trial != nullptr && pass.trial->group != i) continue;
        for (int y = y0 + i / reuse_step; y < std::min(y0 + square, height); y += reuse_step)
          for (int x = x0 + i % reuse_step; x < std::min(x0 + square, width); x += reuse_step)
            visit(x, y);
        end();
      }
}

}  // namespace candela
