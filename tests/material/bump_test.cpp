#include "renderer/material/bump.h"

#include <gtest/gtest.h>

#include <limits>

#include "renderer/base/floating_point_traps.h"
#include "renderer/sampling/sobol.h"
#include "renderer/sampling/warp.h"
#include "tests/image/crafted_files.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

constexpr Vec3f up{0, 0, 1};

void expect_near(const Vec3f& found, const Vec3f& expected, float tolerance = 2e-6f) {
  EXPECT_LT(glm::length(found - expected), tolerance)
      << found.x << " " << found.y << " " << found.z << ", not " << expected.x << " " << expected.y
      << " " << expected.z;
}

// The normal of (u, v) -> p + h n by its definition, in double: the cross product of derivatives.
Vec3f displaced_normal(const Vec3f& dp_du, const Vec3f& dp_dv, Vec2f slope, float scale) {
  const Vec3d n = normalize(cross(Vec3d(dp_du), Vec3d(dp_dv)));
  const double edge = std::sqrt(length(cross(Vec3d(dp_du), Vec3d(dp_dv))));
  const Vec3d du = Vec3d(dp_du) + n * (double{slope.x} * scale * edge);
  const Vec3d dv = Vec3d(dp_dv) + n * (double{slope.y} * scale * edge);
  return Vec3f(normalize(cross(du, dv)));
}

TEST(Unit_Bump, IsTheNormalOfTheDisplacedSurface) {
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const Vec3f dp_du = square_to_uniform_sphere(owen_sobol_2d(i, 1)) * 3.0f;
    const Vec3f dp_dv = square_to_uniform_sphere(owen_sobol_2d(i, 2)) * 0.5f;
    const Vec3f normal = cross(dp_du, dp_dv);
    if (glm::length(normal) < 0.05f) continue;
    const Vec2f slope = owen_sobol_2d(i, 3) * 200.0f - 100.0f;
    expect_near(bump_normal(normalize(normal), dp_du, dp_dv, slope, 0.01f),
                displaced_normal(dp_du, dp_dv, slope, 0.01f), 5e-5f);
  }
}

TEST(Unit_Bump, DependsNeitherOnTheUnitNorOnTheTiling) {
  const Vec3f once = bump_normal(up, {1, 0, 0}, {0, 1, 0}, {3, -2}, 0.1f);
  expect_near(bump_normal(up, {1e6f, 0, 0}, {0, 1e6f, 0}, {3, -2}, 0.1f), once);
  expect_near(bump_normal(up, {1e-9f, 0, 0}, {0, 1e-9f, 0}, {3, -2}, 0.1f), once);
}

TEST(Unit_Bump, OfHeightsThatAreLengthsDependsOnWhatTheyAreLaidOver) {
  const auto slope_of = [](float edge) {
    const Vec3f n = bump_normal(up, {edge, 0, 0}, {0, 2 * edge, 0}, {3, 0}, 0.1f, true);
    return -n.x / n.z;
  };
  EXPECT_NEAR(slope_of(1), 0.3f, 1e-6f);
  EXPECT_NEAR(slope_of(10), 0.03f, 1e-7f);
}

// A height that rises along u leans the normal against u; a mirrored map still rises along its u.
TEST(Unit_Bump, LeansAgainstTheSlope) {
  EXPECT_LT(bump_normal(up, {1, 0, 0}, {0, 1, 0}, {1, 0}, 0.5f).x, -0.1f);
  EXPECT_GT(bump_normal(up, {-1, 0, 0}, {0, 1, 0}, {1, 0}, 0.5f).x, 0.1f);
  EXPECT_LT(bump_normal(up, {1, 0, 0}, {0, -1, 0}, {1, 0}, 0.5f).x, -0.1f);
}

TEST(Unit_Bump, DegenerateMapsLeaveTheNormal) {
  const FloatingPointTraps traps(Traps::Off);  // what is fed is not always a number
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float big = std::numeric_limits<float>::max();
  const std::vector<std::pair<Vec3f, Vec3f>> maps = {
      {{0, 0, 0}, {0, 0, 0}},   {{1, 0, 0}, {0, 0, 0}},          {{1, 0, 0}, {2, 0, 0}},
      {{0, 0, 1}, {1, 0, 0}},   {{nan, 0, 0}, {0, 1, 0}},        {{infinity, 0, 0}, {0, 1, 0}},
      {{big, 0, 0}, {0, 1, 0}}, {{1e-30f, 0, 0}, {0, 1e-30f, 0}}};
  for (const auto& [dp_du, dp_dv] : maps) {
    EXPECT_EQ(bump_normal(up, dp_du, dp_dv, {3, 4}, 1), up);
    EXPECT_EQ(mapped_normal(up, dp_du, dp_dv, {0.9f, 0.5f, 0.8f}, false), up);
  }
}

TEST(Unit_Bump, IsAlwaysAUnitNormalOnTheSameSide) {
  const FloatingPointTraps traps(Traps::Off);  // what is fed is not always a number
  const float big = std::numeric_limits<float>::max();
  for (const float slope : {0.0f, 1e-30f, 1.0f, 1e10f, big, -big, infinity})
    for (const float scale : {0.0f, 0.01f, 1e20f, -1.0f, big}) {
      const Vec3f n = bump_normal(up, {1, 0, 0}, {0.5f, 1, 0}, {slope, -slope}, scale);
      ASSERT_TRUE(is_finite(n));
      EXPECT_NEAR(length_squared(n), 1, 1e-6f);
      EXPECT_GT(n.z, 0);
    }
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const Vec2f u = owen_sobol_2d(i, 1);
    const Vec3f n =
        mapped_normal(up, {1, 0, 0}, {0.5f, 1, 0}, {u.x, u.y, owen_sobol_1d(i, 2)}, false);
    EXPECT_NEAR(length_squared(n), 1, 1e-6f);
    EXPECT_GT(n.z, 0);
  }
}

TEST(Unit_NormalMap, FollowsTheTangentFrame) {
  const Vec3f flat{0.5f, 0.5f, 1};
  const Vec3f along_u{0.8f, 0.5f, 0.9f};
  const Vec3f along_v{0.5f, 0.8f, 0.9f};
  const float c = 1 / std::sqrt(0.6f * 0.6f + 0.8f * 0.8f);
  expect_near(mapped_normal(up, {2, 0, 0}, {0, 3, 0}, flat, false), up);
  expect_near(mapped_normal(up, {2, 0, 0}, {0, 3, 0}, along_u, false), Vec3f{0.6f, 0, 0.8f} * c);
  expect_near(mapped_normal(up, {2, 0, 0}, {0, 3, 0}, along_v, false), Vec3f{0, 0.6f, 0.8f} * c);
  // mirrored: v runs the other way
  expect_near(mapped_normal(up, {2, 0, 0}, {0, -3, 0}, along_v, false), Vec3f{0, -0.6f, 0.8f} * c);
  // or not, as pbrt has it
  expect_near(mapped_normal(up, {2, 0, 0}, {0, -3, 0}, along_v, true), Vec3f{0, 0.6f, 0.8f} * c);
  expect_near(mapped_normal(up, {-2, 0, 0}, {0, 3, 0}, along_v, true), Vec3f{0, -0.6f, 0.8f} * c);
  // turned by 90 degrees
  expect_near(mapped_normal(up, {0, 1, 0}, {-1, 0, 0}, along_u, false), Vec3f{0, 0.6f, 0.8f} * c);
}

// A ramp of 1/16 a texel along u and none along v.
TEST(Unit_Bump, SlopesComeFromTheHeightMap) {
  const TemporaryFolder folder;
  const std::string path = folder.put("h.png", crafted::png_rgba(8, 4, [](int x, int, int) {
                                        return 17u * static_cast<unsigned>(x);
                                      }));
  TextureStore store;
  Diagnostics diagnostics;
  const TextureHandle map = store.add({path, Encoding::Linear, Wrap::Repeat, {}}, diagnostics);
  const Vec2f slope = height_slope(store, map, {Vec2f(0.5f, 0.4f)}, Vec3f(0), Vec3f(0));
  EXPECT_NEAR(slope.x, 17.0f / 255 * 8, 1e-5f);
  EXPECT_NEAR(slope.y, 0, 1e-5f);

  Material material;
  EXPECT_EQ(shading_normal_at(material, store, {}, up, {1, 0, 0}, {0, 1, 0}), up);
  EXPECT_FALSE(has_bump(material));
  material.height = map;
  material.height_scale = 0.5f;
  EXPECT_TRUE(has_bump(material));
  expect_near(shading_normal_at(material, store, {Vec2f(0.5f, 0.4f)}, up, {1, 0, 0}, {0, 1, 0}),
              normalize(Vec3f{-0.5f * 17.0f / 255 * 8, 0, 1}), 1e-5f);
}

// v runs upwards in the picture: a ramp that is brighter in its lower rows falls along v.
TEST(Unit_Bump, HeightsRiseWithVUpwards) {
  const TemporaryFolder folder;
  const std::string path = folder.put("h.png", crafted::png_rgba(4, 8, [](int, int y, int) {
                                        return 17u * static_cast<unsigned>(y);
                                      }));
  TextureStore store;
  Diagnostics diagnostics;
  const TextureHandle map = store.add({path, Encoding::Linear, Wrap::Repeat, {}}, diagnostics);
  EXPECT_NEAR(height_slope(store, map, {Vec2f(0.4f, 0.5f)}, Vec3f(0), Vec3f(0)).y, -17.0f / 255 * 8,
              1e-5f);
}

}  // namespace
}  // namespace candela
