// Triangles from 1e-12 sr to 2 pi, needles and grazing ones among them: what is known of their
// solid angle, and where their samples lie.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/math/constants.h"
#include "renderer/sampling/spherical_triangle.h"
#include "tests/sampling/precise_triangle.h"
#include "tests/stress/row.h"

namespace candela {
namespace {

using namespace test;

struct Seen {
  double count = 0;
  double angle = 0;  // the largest relative error of the solid angle
  double part = 0;   // how far the part of it beside a sample is from the number it was drawn with
};

// The part of the triangle's solid angle between its edge towards b and the line from the apex
// through a sample, in long double.
double part_beside(const PreciseTriangle& t, const Vec2d& weights, double whole) {
  const auto along = static_cast<long double>(weights.y / (weights.x + weights.y));
  const Precise p = t.b + (t.c - t.b) * along;
  return solid_angle({t.a, t.b, p}).steradians / whole;
}

TEST(Stress_SphericalTriangles, From1e12SrToTheHemisphere) {
  std::vector<Seen> decades(14);  // 0: a steradian and more, 12: 1e-12 to 1e-11
  for (std::uint64_t i = 0; i < (is_heavy() ? 4'000'000 : 100'000); ++i) {
    const TriangleCase c = random_triangle(i);
    const PreciseTriangle precise = c.precise();
    const auto [exact, error] = solid_angle(precise);
    if (exact < 1e-12 || exact > 2 * pi_double - 1e-6 || error > 1e-9) continue;
    const SphericalTriangle triangle = make_spherical_triangle(c.apex, c.to_b, c.to_c);
    Seen& seen = decades[static_cast<std::size_t>(std::max(0.0, -std::floor(std::log10(exact))))];
    ++seen.count;
    seen.angle =
        std::max(seen.angle, std::abs(static_cast<double>(triangle.solid_angle) / exact - 1));
    const Vec2f u = light_test::random_pair(i, 20) * 0.98f + 0.01f;
    const double part = part_beside(precise, triangle.point(u), exact);
    seen.part = std::max(seen.part, std::abs(part - static_cast<double>(u.x)));
  }
  for (std::size_t k = 0; k < 13; ++k) {
    const Seen& seen = decades[k];
    add_row(fmt::format("from 1e-{} sr", k),
            {{"triangles", seen.count}, {"relative error", seen.angle}, {"of samples", seen.part}});
    EXPECT_GT(seen.count, 100) << k;
    EXPECT_LT(seen.angle, 5e-7) << k;
    EXPECT_LT(seen.part, 2e-6) << k;
  }
}

}  // namespace
}  // namespace candela
