// What the grid says is what the lookup would have said; where it cannot know it says so.
#include "renderer/material/coverage_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "renderer/base/floating_point_traps.h"
#include "tests/image/crafted_files.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

class Picture {
 public:
  Picture(int width, int height, const crafted::Samples& value) {
    path_ = folder_.put("x.png", crafted::png_rgba(width, height, value));
  }
  TextureHandle with(Wrap wrap) {
    Diagnostics diagnostics;
    return store.add({path_, Encoding::Linear, wrap, {}}, diagnostics);
  }
  TextureStore store;

 private:
  TemporaryFolder folder_;
  std::string path_;
};

// Blobs whose edges pass through cells at every place, with some in between.
unsigned blobs(int x, int y, int c) {
  const double wave = std::sin(x * 0.13 + c) + std::sin(y * 0.09 - c) + std::sin((x + y) * 0.04);
  return static_cast<unsigned>(std::clamp(wave * 400 + 128, 0.0, 255.0));
}

struct Tally {
  int wrong = 0;
  std::array<int, 3> by_coverage{};  // of the lookups
  std::array<int, 3> known{};        // to the grid
};

Tally tally(Picture& picture, Wrap wrap, int channel, bool is_lab) {
  const TextureHandle texture = picture.with(wrap);
  const CoverageGrid grid(picture.store, texture, channel, is_lab);
  std::mt19937 random(11);
  std::uniform_real_distribution<float> uniform(-1.5f, 2.5f);
  Tally tally;
  for (int i = 0; i < 20000; ++i) {
    const Vec2f uv{uniform(random), uniform(random)};
    const float value = picture.store.lookup(texture, uv)[channel];
    const Coverage found = coverage_of_range(value, value, is_lab);
    const Coverage known = grid.at(uv);
    ++tally.by_coverage[static_cast<std::size_t>(found)];
    if (known == Coverage::Partial) continue;
    ++tally.known[static_cast<std::size_t>(found)];
    tally.wrong += known != found;
  }
  return tally;
}

TEST(Unit_CoverageGrid, NeverContradictsTheLookupAndKnowsMost) {
  // 125 and 87: neither is a multiple of a cell's side.
  Picture picture(125, 87, blobs);
  for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp, Wrap::Mirror})
    for (const int channel : {0, 3})
      for (const bool is_lab : {false, true}) {
        const Tally found = tally(picture, wrap, channel, is_lab);
        EXPECT_EQ(found.wrong, 0) << static_cast<int>(wrap) << ' ' << channel << ' ' << is_lab;
        for (const Coverage coverage : {Coverage::Clear, Coverage::Opaque}) {
          const auto i = static_cast<std::size_t>(coverage);
          EXPECT_GT(found.known[i], found.by_coverage[i] / 2);
        }
      }
}

// A single texel that is set must be seen by the cells of all footprints that touch it, those
// across the edge of a repeated picture included.
TEST(Unit_CoverageGrid, SeesEveryTexelOfItsFootprints) {
  for (const int x : {0, 3, 4, 7, 8})
    for (const int y : {0, 3, 4, 7, 8}) {
      Picture picture(9, 9, [&](int i, int j, int) { return i == x && j == y ? 255u : 0u; });
      for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp, Wrap::Mirror})
        EXPECT_EQ(tally(picture, wrap, 3, false).wrong, 0) << x << ' ' << y;
    }
}

// 229.5 of 255 is lab's threshold: texels of 229 and 230 lie on its two sides.
TEST(Unit_CoverageGrid, ThresholdsAreThoseOfTheLookup) {
  const auto coverage = [](unsigned value, bool is_lab) {
    Picture picture(4, 4, [value](int, int, int) { return value; });
    return CoverageGrid(picture.store, picture.with(Wrap::Repeat), 3, is_lab).at({0.4f, 0.7f});
  };
  EXPECT_EQ(coverage(50, true), Coverage::Clear);
  EXPECT_EQ(coverage(51, true), Coverage::Partial);
  EXPECT_EQ(coverage(229, true), Coverage::Partial);
  EXPECT_EQ(coverage(230, true), Coverage::Opaque);
  EXPECT_EQ(coverage(0, false), Coverage::Clear);
  EXPECT_EQ(coverage(1, false), Coverage::Partial);
  EXPECT_EQ(coverage(254, false), Coverage::Partial);
  EXPECT_EQ(coverage(255, false), Coverage::Opaque);
}

// Footprints that begin outside of the picture have no cell.
TEST(Unit_CoverageGrid, LeavesBlackBordersToTheLookup) {
  Picture picture(8, 8, [](int, int, int) { return 255u; });
  const CoverageGrid grid(picture.store, picture.with(Wrap::Black), 3, false);
  for (const float u : {-3.0f, -0.01f, 0.5f, 1.01f, 9.0f})
    EXPECT_EQ(grid.at({u, 0.5f}), Coverage::Partial);
}

TEST(Unit_CoverageGrid, AnyFloatIsACoordinate) {
  const FloatingPointTraps traps(Traps::Off);  // what is fed is not always a number
  Picture picture(8, 8, blobs);
  const CoverageGrid grid(picture.store, picture.with(Wrap::Repeat), 3, false);
  constexpr float largest = std::numeric_limits<float>::max();
  for (const float u : {NAN, HUGE_VALF, -HUGE_VALF, largest, -largest, 1.0f, -1e-10f})
    EXPECT_NE(grid.at({u, u}), static_cast<Coverage>(255)) << u;  // reads no cell that is not there
}

// A file without alpha is opaque.
TEST(Unit_CoverageGrid, MissingAlphaIsOpaque) {
  const TemporaryFolder folder;
  const std::string path =
      folder.put("x.png", crafted::png_of(5, 5, crafted::Rgb, 8, [](int, int, int) { return 0u; }));
  TextureStore store;
  Diagnostics diagnostics;
  const TextureHandle texture = store.add({path, Encoding::Linear, Wrap::Repeat, {}}, diagnostics);
  EXPECT_EQ(CoverageGrid(store, texture, 3, false).at({0.5f, 0.5f}), Coverage::Opaque);
  EXPECT_EQ(CoverageGrid(store, texture, 0, false).at({0.5f, 0.5f}), Coverage::Clear);
}

}  // namespace
}  // namespace candela
