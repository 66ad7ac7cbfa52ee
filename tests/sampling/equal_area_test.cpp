// The equal-area map of the sphere.
#include "renderer/sampling/equal_area.h"

#include <gtest/gtest.h>

#include "renderer/sampling/hash.h"
#include "tests/statistics/chi_square.h"

namespace candela {
namespace {

Vec2f random_point(std::uint64_t i) {
  const std::uint64_t bits = mix_bits(i + 3);
  return {unit_float(static_cast<std::uint32_t>(bits)),
          unit_float(static_cast<std::uint32_t>(bits >> 32))};
}

void expect_near(const Vec3f& found, const Vec3f& expected) {
  EXPECT_LT(length(found - expected), 1e-6f) << found.x << ' ' << found.y << ' ' << found.z;
}

TEST(Unit_EqualArea, AxesLieWhereTheConventionSays) {
  expect_near(square_to_equal_area_sphere({0.5f, 0.5f}), {0, 0, 1});
  expect_near(square_to_equal_area_sphere({1, 0.5f}), {1, 0, 0});
  expect_near(square_to_equal_area_sphere({0, 0.5f}), {-1, 0, 0});
  expect_near(square_to_equal_area_sphere({0.5f, 1}), {0, 1, 0});
  expect_near(square_to_equal_area_sphere({0.5f, 0}), {0, -1, 0});
  for (const float x : {0.0f, 1.0f})
    for (const float y : {0.0f, 1.0f}) expect_near(square_to_equal_area_sphere({x, y}), {0, 0, -1});
}

TEST(Unit_EqualArea, ThereAndBack) {
  for (std::uint64_t i = 0; i < 100'000; ++i) {
    const Vec2f p = random_point(i);
    const Vec3f d = square_to_equal_area_sphere(p);
    ASSERT_NEAR(length(d), 1, 1e-6);
    const Vec3f again = square_to_equal_area_sphere(equal_area_sphere_to_square(d * 3.0f));
    ASSERT_LT(length(again - d), 2e-6f) << p.x << ' ' << p.y;
  }
}

// Next to the poles and the seams too.
TEST(Unit_EqualArea, PointsNearTheEndsAreKept) {
  for (const float e : {1e-3f, 1e-5f, 1e-7f})
    for (const Vec3f d : {Vec3f(e, 2 * e, 1), Vec3f(-e, e, -1), Vec3f(1, e, -e), Vec3f(1, -e, e)}) {
      const Vec3f unit = normalize(d);
      const Vec3f again = square_to_equal_area_sphere(equal_area_sphere_to_square(unit));
      // What half an ulp of a coordinate near 1 moves a direction by.
      EXPECT_LT(length(again - unit), 4e-7f) << e;
    }
}

// Over every edge and corner directions go on as they do within: what is short in the square is
// short on the sphere.
TEST(Unit_EqualArea, TheSquareGoesOnBeyondItsEdges) {
  const auto direction = [](const Vec2f& p) {
    return square_to_equal_area_sphere(wrap_equal_area_square(p));
  };
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    const Vec2f p = random_point(i) * 9.0f - 4.0f;
    const Vec3f d = direction(p);
    ASSERT_NEAR(length(d), 1, 1e-6) << p.x << ' ' << p.y;
    ASSERT_LT(length(direction(p + Vec2f(1e-3f, 0)) - d), 6e-3f) << p.x << ' ' << p.y;
    ASSERT_LT(length(direction(p + Vec2f(0, 1e-3f)) - d), 6e-3f) << p.x << ' ' << p.y;
  }
  for (std::uint64_t i = 0; i < 1000; ++i)
    EXPECT_EQ(wrap_equal_area_square(random_point(i)), random_point(i));
}

// Uniform in z and azimuth.
TEST(Statistical_EqualArea, AreasAreEqual) {
  constexpr int side = 24;
  constexpr int count = 2'000'000;
  std::vector<double> observed(side * side, 0);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vec3f d = square_to_equal_area_sphere(random_point(i));
    const auto cell = [](double unit) {
      return std::clamp(static_cast<int>(unit * side), 0, side - 1);
    };
    const double turns = std::atan2(double{d.y}, double{d.x}) / (2 * pi_double) + 0.5;
    observed[static_cast<std::size_t>(cell(0.5 + 0.5 * double{d.z}) * side + cell(turns))] += 1;
  }
  const std::vector<double> expected(observed.size(), double{count} / (side * side));
  EXPECT_GT(statistics::chi_square_test(observed, expected).p_value, 0.01);
}

}  // namespace
}  // namespace candela
