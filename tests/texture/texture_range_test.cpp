// The range over a triangle holds every lookup within it, and is tight enough to tell leaves from
// air.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "renderer/texture/texture.h"
#include "tests/image/crafted_files.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

using Uvs = Vec2f[3];

double unit_number(std::uint64_t& state) {  // splitmix64
  std::uint64_t z = (state += 0x9E3779B97F4A7C15u);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

TextureHandle added(TextureStore& store, const std::string& path, Wrap wrap) {
  Diagnostics diagnostics;
  return store.add({path, Encoding::Linear, wrap, {}}, diagnostics);
}

Vec2f point_within(const Uvs& uv, std::uint64_t& state) {
  double a = unit_number(state), b = unit_number(state);
  if (a + b > 1) a = 1 - a, b = 1 - b;
  const Vec2d p =
      Vec2d(uv[0]) + a * (Vec2d(uv[1]) - Vec2d(uv[0])) + b * (Vec2d(uv[2]) - Vec2d(uv[0]));
  return Vec2f(p);
}

// Random alpha, so that a texel missed is a range too narrow.
TEST(Unit_TextureRange, HoldsEveryLookupWithinTheTriangle) {
  const TemporaryFolder folder;
  std::uint64_t state = 17;
  std::vector<unsigned> noise(37 * 23 * 4);
  for (unsigned& value : noise) value = static_cast<unsigned>(unit_number(state) * 256);
  const std::string path =
      folder.put("x.png", crafted::png_rgba(37, 23, [&](int x, int y, int c) {
                   return noise[static_cast<std::size_t>((y * 37 + x) * 4 + c)];
                 }));
  TextureStore store;
  for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp, Wrap::Mirror, Wrap::Black}) {
    const TextureHandle texture = added(store, path, wrap);
    for (int i = 0; i < 400; ++i) {
      const double size = std::exp2(-7 * unit_number(state));
      const double far = i % 4 == 0 ? 40 : 2;
      Uvs uv;
      const Vec2d middle{(unit_number(state) - 0.3) * far, (unit_number(state) - 0.3) * far};
      for (Vec2f& p : uv)
        p = Vec2f(middle + size * Vec2d(unit_number(state) - 0.5, unit_number(state) - 0.5));
      const int channel = i % 2 == 0 ? 3 : 1;
      const TextureStore::Range range = store.range_in_triangle(texture, uv, channel);
      for (int k = 0; k < 200; ++k) {
        const float value = store.lookup(texture, point_within(uv, state))[channel];
        ASSERT_GE(value, range.low) << i;
        ASSERT_LE(value, range.high) << i;
      }
    }
  }
}

// Against every texel whose footprint, a square of two texels, the triangle really meets, found by
// sampling it densely.
TEST(Unit_TextureRange, IsNoWiderThanTheTexelsAroundTheTriangle) {
  const TemporaryFolder folder;
  constexpr int side = 64;
  const std::string path = folder.put("x.png", crafted::png_rgba(side, side, [](int x, int y, int) {
                                        return static_cast<unsigned>(x * 3 + y / 2) % 256;
                                      }));
  TextureStore store;
  const TextureHandle texture = added(store, path, Wrap::Repeat);
  std::uint64_t state = 5;
  for (int i = 0; i < 50; ++i) {
    Uvs uv;
    for (Vec2f& p : uv)
      p = {static_cast<float>(0.1 + 0.8 * unit_number(state)),
           static_cast<float>(0.1 + 0.8 * unit_number(state))};
    const TextureStore::Range range = store.range_in_triangle(texture, uv, 3);
    float low = 1, high = 0;
    for (int k = 0; k < 4000; ++k) {
      const float value = store.lookup(texture, point_within(uv, state)).w;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    const float two_texels = (2 * 3 + 1 + 1) / 255.0f;
    EXPECT_GT(range.low, low - 1.5f * two_texels);
    EXPECT_LT(range.high, high + 1.5f * two_texels);
  }
}

// A round leaf on a clear card, cut into a grid: most of the triangles are wholly one or the other.
TEST(Unit_TextureRange, ClassifiesTheTrianglesOfALeafCard) {
  const TemporaryFolder folder;
  constexpr int side = 256;
  const std::string path =
      folder.put("leaf.png", crafted::png_rgba(side, side, [](int x, int y, int) {
                   return std::hypot(x - 128, y - 128) < 100 ? 255u : 0u;
                 }));
  TextureStore store;
  const TextureHandle texture = added(store, path, Wrap::Repeat);
  constexpr int grid = 16;
  int opaque = 0, clear = 0, mixed = 0;
  for (int i = 0; i < grid * grid; ++i) {
    const float u = static_cast<float>(i % grid) / grid, v = static_cast<float>(i / grid) / grid;
    constexpr float step = 1.0f / grid;
    const Uvs uv{{u, v}, {u + step, v}, {u, v + step}};
    const TextureStore::Range range = store.range_in_triangle(texture, uv, 3);
    opaque += range.low == 1;
    clear += range.high == 0;
    mixed += range.low < 1 && range.high > 0;
  }
  // The circle passes through about 8/pi * 100/16 = 50 of the 256 cells, half of which its edge
  // also leaves through the triangle looked at.
  EXPECT_GT(opaque, 90);
  EXPECT_GT(clear, 90);
  EXPECT_LT(mixed, 60);
}

TEST(Unit_TextureRange, FollowsTheRepeatAcrossTheEdge) {
  const TemporaryFolder folder;
  const std::string path = folder.put(
      "x.png", crafted::png_rgba(16, 16, [](int x, int, int) { return x == 0 ? 255u : 0u; }));
  TextureStore store;
  const auto range_of = [&](Wrap wrap, float u) {
    const Uvs uv{{u, 0.5f}, {u + 0.001f, 0.5f}, {u, 0.501f}};
    return store.range_in_triangle(added(store, path, wrap), uv, 3);
  };
  const float last_centre = 15.7f / 16;  // beyond the last texel's centre, on the way to the first
  EXPECT_NEAR(range_of(Wrap::Repeat, last_centre).high, 1, 1e-6);
  EXPECT_NEAR(range_of(Wrap::Repeat, last_centre - 3).high, 1, 1e-6);
  EXPECT_EQ(range_of(Wrap::Clamp, last_centre).high, 0);
  EXPECT_EQ(range_of(Wrap::Mirror, last_centre).high, 0);
  EXPECT_EQ(range_of(Wrap::Repeat, 0.5f).high, 0);
  EXPECT_EQ(range_of(Wrap::Clamp, -7).low, 1);
  EXPECT_EQ(range_of(Wrap::Black, -7).high, 0);
  EXPECT_LE(range_of(Wrap::Black, 0).low, 0);
}

TEST(Unit_TextureRange, WideOrUndefinedTrianglesGiveTheWholeImage) {
  const TemporaryFolder folder;
  const std::string path = folder.put("x.png", crafted::png_rgba(16, 16, [](int x, int y, int) {
                                        return x == 3 && y == 4 ? 255u : 51u;
                                      }));
  TextureStore store;
  const TextureHandle texture = added(store, path, Wrap::Repeat);
  for (const float u : {5.0f, 1e20f, std::numeric_limits<float>::infinity(), NAN}) {
    const TextureStore::Range range = store.range_in_triangle(texture, {{0, 0}, {u, 0}, {0, u}}, 3);
    EXPECT_NEAR(range.low, 0.2f, 1e-6);
    EXPECT_NEAR(range.high, 1, 1e-6);
  }
  // One point far away: the margin of its roundings reaches beyond the image.
  const TextureStore::Range far =
      store.range_in_triangle(texture, {{1e9f, 0}, {1e9f, 0}, {1e9f, 0}}, 3);
  EXPECT_NEAR(far.high, 1, 1e-6);
}

TEST(Unit_TextureRange, OfAFileWithoutAlphaIsOne) {
  const TemporaryFolder folder;
  const std::string path = folder.put(
      "x.png", crafted::png_of(4, 4, crafted::Grey, 8, [](int, int, int) { return 51u; }));
  TextureStore store;
  const TextureHandle texture = added(store, path, Wrap::Repeat);
  const Uvs uv{{0, 0}, {1, 0}, {0, 1}};
  EXPECT_EQ(store.range_in_triangle(texture, uv, 3).low, 1);
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_EQ(store.range_in_triangle(texture, uv, channel).low, 0.2f);
    EXPECT_EQ(store.range_in_triangle(texture, uv, channel).high, 0.2f);
  }
}

}  // namespace
}  // namespace candela
