#include "renderer/sampling/spherical_rectangle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/light/directions.h"
#include "tests/statistics/chi_square.h"
#include "tests/statistics/distributions.h"

namespace candela {
namespace {

// Of the rectangle from (0, 0) to (x, y), whose sign is that of x y.
long double corner_angle(long double x, long double y, long double height) {
  return std::atan2(x * y, height * std::sqrt(x * x + y * y + height * height));
}
long double solid_angle(long double x0, long double y0, long double x1, long double y1,
                        long double height) {
  return corner_angle(x1, y1, height) - corner_angle(x0, y1, height) -
         corner_angle(x1, y0, height) + corner_angle(x0, y0, height);
}

struct RectangleCase {
  const char* name;
  double x0, y0, x1, y1, height;
};

const std::vector<RectangleCase>& cases() {
  static const std::vector<RectangleCase> all{
      {"square above", -1, -1, 1, 1, 1},
      {"aside", 0.5, 1, 2, 1.5, 0.7},
      {"nearly all of the hemisphere", -1, -1, 1, 1, 1e-4},
      {"beside a corner, close to its plane", 1e-3, 1e-3, 1, 1, 1e-3},
      {"grazing", 1, -1, 3, 1, 0.02},
      {"needle", -5, -1e-3, 5, 1e-3, 0.3},
      {"needle that points here", 1e-2, -1e-3, 10, 1e-3, 1e-2},
      {"far", 100, 200, 101, 202, 300},
  };
  return all;
}

SphericalRectangle made(const RectangleCase& c) {
  return make_spherical_rectangle(c.x0, c.y0, c.x1, c.y1, c.height);
}

// From 1e-12 sr to 2 pi, with sides a thousand times as long as each other, and grazing ones. What
// 1e-16 of rounding leaves of the small ones is less than floats lose of the large ones.
TEST(Unit_SphericalRectangle, SolidAngleIsThatOfMorePrecision) {
  double least = 1, most = 0;
  for (std::uint64_t i = 0; i < 100'000; ++i) {
    const auto decades = [&](std::uint64_t stream, double low, double high) {
      const auto u = static_cast<double>(light_test::random_unit(i, stream));
      return std::pow(10.0, low + u * (high - low));
    };
    const double x0 = light_test::random_unit(i, 1) < 0.5f ? -decades(2, -2, 2) : decades(2, -2, 2);
    const double y0 = light_test::random_unit(i, 3) < 0.5f ? -decades(4, -2, 2) : decades(4, -2, 2);
    const double x1 = x0 + decades(5, -4, 2);
    const double y1 = y0 + decades(6, -4, 2);
    const double height = decades(7, -4, 2);
    const auto exact = static_cast<double>(solid_angle(x0, y0, x1, y1, height));
    const double found =
        static_cast<double>(make_spherical_rectangle(x0, y0, x1, y1, height).solid_angle);
    ASSERT_NEAR(found, exact, 1e-6 * exact + 2e-15)
        << x0 << " " << y0 << " " << x1 << " " << y1 << " " << height;
    least = std::min(least, exact);
    most = std::max(most, exact);
  }
  EXPECT_LT(least, 1e-12);
  EXPECT_GT(most, 6.28);
}

TEST(Unit_SphericalRectangle, HasNoneInItsOwnPlane) {
  for (const double x : {-2.0, -0.5, 1.5})
    EXPECT_FALSE(make_spherical_rectangle(x, -1, x + 1, 1, 0).solid_angle > 0) << x;
  EXPECT_FALSE(make_spherical_rectangle(0, -1, 1, 1, 0).solid_angle > 0) << "on an edge";
  EXPECT_FALSE(make_spherical_rectangle(0, 0, 1, 1, 0).solid_angle > 0) << "on a corner";
}

TEST(Unit_SphericalRectangle, PointsAreWithinAndComeBack) {
  for (const RectangleCase& c : cases()) {
    const SphericalRectangle rectangle = made(c);
    for (std::uint64_t i = 0; i < 10'000; ++i) {
      const Vec2f u = i < 4 ? Vec2f(static_cast<float>(i / 2), static_cast<float>(i % 2))
                            : light_test::random_pair(i, 11);
      const Vec2d point = rectangle.point(u);
      ASSERT_TRUE(point.x >= c.x0 && point.x <= c.x1 && point.y >= c.y0 && point.y <= c.y1)
          << c.name << " " << u.x << " " << u.y << ": " << point.x << " " << point.y;
      const Vec2f place = rectangle.place_of(point);
      ASSERT_NEAR(place.x, u.x, 2e-5) << c.name;
      ASSERT_NEAR(place.y, u.y, 2e-5) << c.name;
    }
  }
}

// Cells of equal size in the square's own measure would be what is tested; these are of the plane,
// with the solid angles of more precision.
TEST(Statistical_SphericalRectangle, PointsAreUniformInSolidAngle) {
  constexpr int bins = 32;
  constexpr int count = 400'000;
  for (const RectangleCase& c : cases()) {
    const SphericalRectangle rectangle = made(c);
    std::vector<double> observed(bins * bins), expected(bins * bins);
    // Narrow towards the foot of the perpendicular, where the solid angle is.
    const auto edges = [&](double low, double high) {
      std::vector<double> at(bins + 1);
      const double first = std::asinh(low / c.height), last = std::asinh(high / c.height);
      for (int i = 0; i <= bins; ++i)
        at[static_cast<std::size_t>(i)] = c.height * std::sinh(first + (last - first) * i / bins);
      return at;
    };
    const std::vector<double> xs = edges(c.x0, c.x1), ys = edges(c.y0, c.y1);
    const auto bin = [](const std::vector<double>& at, double x) {
      const auto above = std::upper_bound(at.begin() + 1, at.end() - 1, x);
      return static_cast<std::size_t>(above - at.begin() - 1);
    };
    for (std::uint64_t i = 0; i < count; ++i) {
      const Vec2d point = rectangle.point(light_test::random_pair(i, 12));
      ++observed[bin(xs, point.x) * bins + bin(ys, point.y)];
    }
    const long double all = solid_angle(c.x0, c.y0, c.x1, c.y1, c.height);
    for (std::size_t x = 0; x < bins; ++x)
      for (std::size_t y = 0; y < bins; ++y)
        expected[x * bins + y] = static_cast<double>(
            count * solid_angle(xs[x], ys[y], xs[x + 1], ys[y + 1], c.height) / all);
    const auto result = statistics::chi_square_test(observed, expected);
    EXPECT_GT(result.p_value, statistics::sidak_level(0.01, static_cast<double>(cases().size())))
        << c.name << ": " << result.statistic << " of " << result.degrees_of_freedom;
  }
}

}  // namespace
}  // namespace candela
