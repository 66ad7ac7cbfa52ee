#include "renderer/sampling/spherical_triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "renderer/math/constants.h"
#include "tests/light/directions.h"
#include "tests/sampling/precise_triangle.h"
#include "tests/statistics/chi_square.h"
#include "tests/statistics/distributions.h"

namespace candela {
namespace {

using test::angle_between;
using test::Precise;
using test::random_triangle;
using test::solid_angle;
using test::TriangleCase;

const std::vector<TriangleCase>& cases() {
  static const std::vector<TriangleCase> all{
      {"above", {-1, -0.5, 1}, {2, 0, 0}, {0.5, 1.5, 0}},
      {"clockwise, tilted", {0.5, 1, -0.7}, {0.3, 1.5, 0.4}, {2, 0, -1}},
      {"nearly all of the hemisphere", {-1, -0.5, 1e-4}, {2, 0, 0}, {0.5, 1.5, 0}},
      {"all but 1e-7 of it", {-1, -0.5, 1e-8}, {2, 0, 0}, {0.5, 1.5, 0}},
      {"close above an edge", {-1, -1e-5, 1e-5}, {2, 0, 0}, {0.5, 1.5, 0}},
      {"close above the apex", {-1e-4, -1e-4, 1e-4}, {2, 0, 0}, {0.5, 1.5, 0}},
      {"close above another vertex", {-2, 1e-4, 1e-4}, {2, 0, 0}, {0.5, 1.5, 0}},
      {"grazing", {1, -1, 0.02}, {2, 0, 0}, {0.5, 1.5, 0}},
      {"needle", {-5, -1e-3, 0.3}, {10, 0, 0}, {10, 2e-3, 0}},
      {"needle that points here", {1e-2, -1e-3, 1e-2}, {10, 0, 0}, {10, 2e-3, 0}},
      {"needle across, by its blunt end", {-5, 0, 1e-3}, {0, 1e-3, 0}, {10, 2e-4, 0}},
      {"far", {100, 200, 300}, {1, 0, 0.5}, {0, 1, 0.2}},
      {"1e-12 sr", {0.3e6, 0.4e6, 0.9e6}, {1, 0, 0.5}, {0, 1, 0.2}},
  };
  return all;
}

SphericalTriangle made(const TriangleCase& c) {
  return make_spherical_triangle(c.apex, c.to_b, c.to_c);
}
TEST(Unit_SphericalTriangle, SolidAngleIsThatOfMorePrecision) {
  double least = 1, most = 0;
  int compared = 0;  // sharply
  for (std::uint64_t i = 0; i < 200'000; ++i) {
    const TriangleCase c = random_triangle(i);
    const auto [exact, error] = solid_angle(c.precise());
    if (exact < 1e-13 || error > 1e-3) continue;
    const auto found = static_cast<double>(made(c).solid_angle);
    ASSERT_NEAR(found / exact, 1, 5e-7 + error) << i << ": " << exact;
    compared += error < 1e-7 ? 1 : 0;
    least = std::min(least, exact);
    most = std::max(most, exact);
  }
  EXPECT_LT(least, 1e-12);
  EXPECT_GT(most, 6.283);
  EXPECT_GT(compared, 100'000);
}

TEST(Unit_SphericalTriangle, KnowsAnOctantAndAHemisphere) {
  EXPECT_FLOAT_EQ(make_spherical_triangle({1, 0, 0}, {-1, 1, 0}, {-1, 0, 1}).solid_angle, pi / 2);
  EXPECT_FLOAT_EQ(make_spherical_triangle({-1, -1, 1e-12}, {3, 0, 0}, {0, 3, 0}).solid_angle,
                  2 * pi);
}

TEST(Unit_SphericalTriangle, HasNoneInItsOwnPlane) {
  for (const Vec3d& apex : {Vec3d(1, 1, 0), Vec3d(-0.2, -0.2, 0), Vec3d(-2, -2, 0)})
    EXPECT_EQ(make_spherical_triangle(apex, {1, 0, 0}, {0, 1, 0}).solid_angle, 0) << "in it";
  EXPECT_EQ(make_spherical_triangle({0, -0.5, 0}, {1, 0, 0}, {0, 1, 0}).solid_angle, 0) << "edge";
  for (const Vec3d& apex : {Vec3d(0, 0, 0), Vec3d(-1, 0, 0), Vec3d(0, -1, 0)})
    EXPECT_EQ(make_spherical_triangle(apex, {1, 0, 0}, {0, 1, 0}).solid_angle, 0) << "vertex";
}

TEST(Unit_SphericalTriangle, PointsAreWithinAndComeBack) {
  std::vector<TriangleCase> all = cases();
  for (std::uint64_t i = 0; i < 1000; ++i) all.push_back(random_triangle(i));
  for (const TriangleCase& c : all) {
    const SphericalTriangle triangle = made(c);
    if (!(triangle.solid_angle > 1e-13f)) continue;
    for (std::uint64_t i = 0; i < 1000; ++i) {
      const Vec2f u = i < 4 ? Vec2f(static_cast<float>(i / 2), static_cast<float>(i % 2))
                            : light_test::random_pair(i, 11);
      const Vec2d weights = triangle.point(u);
      ASSERT_TRUE(weights.x >= 0 && weights.y >= 0 && weights.x + weights.y <= 1 + 1e-12)
          << c.name << " " << u.x << " " << u.y << ": " << weights.x << " " << weights.y;
      if (u.y < 1e-3f) continue;  // at the apex, where all u.x meet
      const Vec3d p = c.apex + c.to_b * weights.x + c.to_c * weights.y;
      const Vec2f place = triangle.place_of(normalize(p));
      ASSERT_NEAR(place.x, u.x, 1e-4) << c.name;
      ASSERT_NEAR(place.y, u.y, 1e-4) << c.name;
    }
  }
}

// The triangle in halves again and again, across the longest side as it is seen, until none has
// more than the given part of it. Their solid angles are known to more precision, whatever the
// sampler does.
struct Cells {
  TriangleCase triangle;
  double largest;  // solid angle of a cell
  std::vector<double> solid_angles, counts;

  // A part of the triangle: weights of b and c at its corners.
  using Part = std::array<Vec2d, 3>;

  [[nodiscard]] Precise at(const Vec2d& weights) const {
    return Precise(triangle.apex) + (Precise(triangle.to_b) * static_cast<long double>(weights.x) +
                                     Precise(triangle.to_c) * static_cast<long double>(weights.y));
  }
  // The corner opposite of the longest side first.
  [[nodiscard]] Part turned(const Part& part) const {
    std::size_t longest = 0;
    long double most = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      const long double angle = angle_between(at(part[(i + 1) % 3]), at(part[(i + 2) % 3]));
      if (angle > most) longest = i, most = angle;
    }
    return {part[longest], part[(longest + 1) % 3], part[(longest + 2) % 3]};
  }
  // Where the longest side is halved, in angle.
  [[nodiscard]] Vec2d middle(const Part& part) const {
    const long double length1 = glm::length(at(part[1]));
    const long double length2 = glm::length(at(part[2]));
    const auto share = static_cast<double>(length1 / (length1 + length2));
    return part[1] + (part[2] - part[1]) * share;
  }
  void split(const Part& any, std::vector<Vec2d>& samples) {
    const double whole = solid_angle({at(any[0]), at(any[1]), at(any[2])}).steradians;
    if (whole <= largest) {
      solid_angles.push_back(whole);
      counts.push_back(static_cast<double>(samples.size()));
      return;
    }
    const Part part = turned(any);
    const Vec2d cut = middle(part);
    // On the side of corner 1, of the line from corner 0.
    const auto side = [&](const Vec2d& p) {
      const Vec2d d = cut - part[0];
      return d.x * (p.y - part[0].y) - d.y * (p.x - part[0].x);
    };
    const double sign = side(part[1]);
    const auto end = std::partition(samples.begin(), samples.end(),
                                    [&](const Vec2d& p) { return side(p) * sign > 0; });
    std::vector<Vec2d> first(samples.begin(), end), second(end, samples.end());
    split({part[0], part[1], cut}, first);
    split({part[0], cut, part[2]}, second);
  }
};

TEST(Statistical_SphericalTriangle, PointsAreUniformInSolidAngle) {
  constexpr int count = 200'000;
  for (const TriangleCase& c : cases()) {
    const SphericalTriangle triangle = made(c);
    std::vector<Vec2d> samples;
    for (std::uint64_t i = 0; i < count; ++i)
      samples.push_back(triangle.point(light_test::random_pair(i, 12)));
    Cells cells{c, static_cast<double>(triangle.solid_angle) / 400, {}, {}};
    cells.split({Vec2d(0, 0), Vec2d(1, 0), Vec2d(0, 1)}, samples);
    double sum = 0;
    for (const double angle : cells.solid_angles) sum += angle;
    EXPECT_NEAR(sum / static_cast<double>(triangle.solid_angle), 1, 1e-6) << c.name;
    for (double& angle : cells.solid_angles) angle *= count / sum;
    const auto result = statistics::chi_square_test(cells.counts, cells.solid_angles);
    EXPECT_GT(result.p_value, statistics::sidak_level(0.01, static_cast<double>(cases().size())))
        << c.name << ": " << result.statistic << " of " << result.degrees_of_freedom;
    EXPECT_GT(result.degrees_of_freedom, 200) << c.name;
  }
}

}  // namespace
}  // namespace candela
