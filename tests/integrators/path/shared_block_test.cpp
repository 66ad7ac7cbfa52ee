// Blocks that several pixels fill: which pixels those are follows from the picture alone.
#include "integrators/path/shared_block.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <utility>

#include "tests/scenes/coincident_walls.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using namespace test;

using Pixels = std::vector<std::pair<int, int>>;

Pixels pixels_of(const PixelRect& square) {
  Pixels pixels;
  for_each_pixel_near(square, [&](int x, int y) { pixels.emplace_back(x, y); });
  return pixels;
}

TEST(Unit_SharedBlock, SquaresOfAnyTileAreThoseOfThePicture) {
  constexpr int width = 30, height = 9;
  const auto squares_of = [](const PixelRect& tile) {
    std::set<Pixels> squares;
    for_each_square(shared_side, tile, width, height,
                    [&](const PixelRect& square) { squares.insert(pixels_of(square)); });
    return squares;
  };
  const std::set<Pixels> all = squares_of({0, 0, width, height});
  std::set<std::pair<int, int>> covered;
  for (const Pixels& square : all)
    for (const auto& pixel : square) EXPECT_TRUE(covered.insert(pixel).second);
  EXPECT_EQ(covered.size(), std::size_t{width * height});
  for (const PixelRect& tile :
       {PixelRect{0, 0, 16, 9}, PixelRect{3, 5, 4, 6}, PixelRect{27, 1, 30, 9}}) {
    std::set<std::pair<int, int>> of_tile;
    for (const Pixels& square : squares_of(tile)) {
      EXPECT_TRUE(all.contains(square));
      of_tile.insert(square.begin(), square.end());
    }
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x) EXPECT_TRUE(of_tile.contains({x, y}));
  }
}

// Two of them are beside each other, four a square.
TEST(Unit_SharedBlock, PixelsThatFollowEachOtherAreNear) {
  const Pixels pixels = pixels_of({8, 4, 12, 8});
  ASSERT_EQ(pixels.size(), block_size);
  for (std::size_t i = 0; i < block_size; ++i) {
    const auto& [x, y] = pixels[i];
    EXPECT_LE(std::abs(x - pixels[i - i % 2].first), 1);
    EXPECT_EQ(y, pixels[i - i % 2].second);
    EXPECT_LE(std::abs(x - pixels[i - i % 4].first), 1);
    EXPECT_LE(std::abs(y - pixels[i - i % 4].second), 1);
  }
}

TEST(Unit_SharedBlock, IsForPassesThatDoNotFillBlocks) {
  TilePass pass;
  for (const SampleRange& range : {SampleRange{0, 16}, SampleRange{32, 64}}) {
    pass.range = range;
    EXPECT_FALSE(leaves_lanes_empty(pass));
  }
  for (const SampleRange& range : {SampleRange{0, 1}, SampleRange{1, 16}, SampleRange{16, 20}}) {
    pass.range = range;
    EXPECT_TRUE(leaves_lanes_empty(pass));
  }
  const SampleDensity density;
  pass.range = {0, 16};
  pass.density = &density;
  EXPECT_TRUE(leaves_lanes_empty(pass));
}

TEST(Unit_SharedBlock, SplitPathsAndObserversHaveNone) {
  TilePass pass;
  pass.range = {0, 9};
  RenderOptions options;
  EXPECT_TRUE(shares_blocks(options, pass));
  pass.plan.splitting = 2;
  EXPECT_FALSE(shares_blocks(options, pass));
  pass.plan.splitting = 1;
  options.savings.shares_blocks = false;
  EXPECT_FALSE(shares_blocks(options, pass));
}

TEST(Agreement_SharedBlock, CompanyChangesNoBit) {
  for (const int samples : {1, 3, 7, 15}) {
    RenderSettings settings = settings_of(30, samples);
    settings.accelerator = AcceleratorKind::Embree;
    const Scene scene = compiled(walls_of_two_colours(), settings.options);
    const Image whole = picture(scene, settings);
    EXPECT_GT(mean_of(whole), 0.01);
    expect_same_bits_however_rendered(scene, settings, whole, {5, 3, 18, 30});
  }
}

}  // namespace
}  // namespace candela
