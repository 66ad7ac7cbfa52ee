// Tone curves against their definitions, and that they stay within 0..255.
#include "renderer/image/display_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace candela {
namespace {

double srgb(double v) {
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

double curve(ToneMap map, double v) {
  switch (map) {
    case ToneMap::Srgb:
      return srgb(std::min(v, 1.0));
    case ToneMap::Aces: {
      const double fitted = v * (2.51 * v + 0.03) / (v * (2.43 * v + 0.59) + 0.14);
      return srgb(std::min(fitted, 1.0));
    }
    case ToneMap::Lab3:
      return std::min(std::pow(v, 1 / 2.2), 1.0);
  }
  return 0;
}

TEST(Unit_DisplayTransform, FollowsItsCurvesAndExposure) {
  for (const ToneMap map : {ToneMap::Srgb, ToneMap::Aces, ToneMap::Lab3})
    for (const double exposure : {0.0, -2.5, 1.0})
      for (int i = 0; i <= 400; ++i) {
        const double linear = std::pow(i / 200.0, 3);
        const double expected = 255 * curve(map, linear * std::pow(2, exposure));
        ASSERT_NEAR(display_value(linear, {map, exposure}), expected, 0.5 + 1e-9);
      }
}

TEST(Unit_DisplayTransform, TakesAnyNumber) {
  for (const ToneMap map : {ToneMap::Srgb, ToneMap::Aces, ToneMap::Lab3}) {
    EXPECT_EQ(display_value(0, {map, 0}), 0);
    EXPECT_EQ(display_value(-1, {map, 0}), 0);
    EXPECT_EQ(display_value(std::numeric_limits<double>::quiet_NaN(), {map, 0}), 0);
    EXPECT_EQ(display_value(std::numeric_limits<double>::infinity(), {map, 0}), 255);
    EXPECT_EQ(display_value(1e300, {map, 0}), 255);
    EXPECT_EQ(display_value(1, {map, 2000}), 255);
    EXPECT_EQ(display_value(1, {map, -2000}), 0);
  }
}

TEST(Unit_DisplayTransform, ThreeBytesOrFour) {
  Image image(1, 1, {"A", "B", "G", "R"});
  image.values = {0.5f, 0.0f, 0.25f, 0.5f};
  EXPECT_EQ(display_bytes(image, {}, false), (std::vector<std::uint8_t>{188, 137, 0}));
  EXPECT_EQ(display_bytes(image, {}, true), (std::vector<std::uint8_t>{255, 188, 0, 128}));
}

}  // namespace
}  // namespace candela
