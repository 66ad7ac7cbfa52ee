// Tiles cover what is rendered, and cut it where they would cut the whole picture.
#include "renderer/film/tiles.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

TEST(Unit_Tiles, CoverARectangleOnceAndCutItAtTheSamePlaces) {
  constexpr int size = 8;
  for (const PixelRect& rect :
       {PixelRect{0, 0, 40, 21}, PixelRect{5, 3, 6, 4}, PixelRect{7, 8, 33, 17}}) {
    std::vector<int> times(40 * 21, 0);
    for (const PixelRect& tile : tiles_of(rect, size)) {
      EXPECT_EQ(tile.x0 / size, (tile.x1 - 1) / size);
      EXPECT_EQ(tile.y0 / size, (tile.y1 - 1) / size);
      for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) ++times[static_cast<std::size_t>(y * 40 + x)];
    }
    for (int y = 0; y < 21; ++y)
      for (int x = 0; x < 40; ++x)
        EXPECT_EQ(times[static_cast<std::size_t>(y * 40 + x)], rect.contains(x, y) ? 1 : 0)
            << x << " " << y;
  }
}

}  // namespace
}  // namespace candela
