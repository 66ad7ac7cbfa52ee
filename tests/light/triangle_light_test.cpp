#include "renderer/light/triangle_light.h"

#include <gtest/gtest.h>

#include "renderer/light/make_light.h"
#include "renderer/light/sample_light.h"
#include "tests/light/directions.h"
#include "tests/light/finite_samples.h"
#include "tests/light/met_lamp.h"
#include "tests/statistics/distributions.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using light_test::Cap;

struct TriangleCase {
  const char* name;
  std::array<Vec3f, 3> vertices;
  Vec3f p;
  double cos_min;  // a cap about the centroid that holds the triangle as seen from p
};

const std::vector<TriangleCase>& cases() {
  static const std::vector<TriangleCase> all{
      {"facing", {Vec3f(-1, -1, 2), {1, -1, 2}, {0, 1, 2}}, {0, 0, 0}, 0.7},
      {"oblique", {Vec3f(0, 0, 0), {1, 0, 0}, {0, 1, 0}}, {2, 0.3f, 0.2f}, 0.94},
      {"near its plane and inside", {Vec3f(0, 0, 0), {1, 0, 0}, {0, 1, 0}}, {0.3f, 0.3f, 0.1f}, -1},
      {"far", {Vec3f(0, 0, 1000), {1, 0, 1000}, {0, 1, 1000.5f}}, {3, 4, 0}, 1 - 1e-6},
      {"tiny units", {Vec3f(0, 0, 2e-9f), {1e-9f, 0, 2e-9f}, {0, 1e-9f, 3e-9f}}, {0, 0, 0}, 0.75},
      {"narrow", {Vec3f(-0.1f, 0, 1), {0.1f, 0, 1}, {0, 0.02f, 1}}, {0, 0.007f, 0.95f}, 0.3},
  };
  return all;
}

Cap cap_of(const TriangleCase& c) {
  const Vec3f centroid = (c.vertices[0] + c.vertices[1] + c.vertices[2]) * (1.0f / 3.0f);
  return {frame_from_normal(normalize(centroid - c.p)), c.cos_min};
}

// Where the ray from p along d meets the triangle, in double; 0 where it does not.
double distance_to(const TriangleCase& c, const Vec3f& d) {
  const Vec3d e1 = Vec3d(c.vertices[1]) - Vec3d(c.vertices[0]);
  const Vec3d e2 = Vec3d(c.vertices[2]) - Vec3d(c.vertices[0]);
  const Vec3d s = Vec3d(c.p) - Vec3d(c.vertices[0]);
  const Vec3d h = cross(Vec3d(d), e2);
  const double determinant = dot(e1, h);
  const double u = dot(s, h) / determinant;
  const Vec3d q = cross(s, e1);
  const double v = dot(Vec3d(d), q) / determinant;
  const double t = dot(e2, q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : 0;
}

double pdf_towards(const TriangleCase& c, const light_test::MetLamp& lamp, const Vec3f& d) {
  const double t = distance_to(c, d);
  if (!(t > 0)) return 0;
  return static_cast<double>(lamp.pdf(c.p, Vec3f(0), d, t));
}

TEST(Statistical_TriangleLight, DensityIntegratesToOne) {
  for (const TriangleCase& c : cases()) {
    const Light light = make_triangle_light(c.vertices, Rgb(1), true);
    const light_test::MetLamp lamp(light);
    const statistics::Moments sum = light_test::random_integral(
        cap_of(c), 1'000'000, [&](const Vec3f& d) { return pdf_towards(c, lamp, d); });
    EXPECT_GT(sum.p_value(1), 1e-4) << c.name << ": " << sum.mean();
    EXPECT_LT(sum.standard_error(), 0.01) << c.name;
  }
}

TEST(Statistical_TriangleLight, SamplesFitTheDensity) {
  for (const TriangleCase& c : cases()) {
    const Light light = make_triangle_light(c.vertices, Rgb(1), true);
    const light_test::MetLamp lamp(light);
    const auto sample = [&](Vec2f u) -> std::optional<Vec3f> {
      return sample_light({}, light, light_test::at(c.p), u).wi;
    };
    const double p_value = light_test::chi_square_p_value(
        cap_of(c), 40, 1'000'000, sample, [&](const Vec3f& d) { return pdf_towards(c, lamp, d); });
    EXPECT_GT(p_value, statistics::sidak_level(0.01, static_cast<double>(cases().size())))
        << c.name;
  }
}

TEST(Unit_TriangleLight, SampleAndPdfAgreeAndEndOnTheTriangle) {
  for (const TriangleCase& c : cases()) {
    const Light light = make_triangle_light(c.vertices, Rgb(1, 2, 3), true);
    const light_test::MetLamp lamp(light);
    for (std::uint64_t i = 0; i < 1000; ++i) {
      const LightSample s =
          sample_light({}, light, light_test::at(c.p), light_test::random_pair(i, 3));
      ASSERT_TRUE(s.is_valid()) << c.name;
      EXPECT_EQ(s.radiance, Rgb(1, 2, 3));
      EXPECT_NEAR(length(s.wi), 1, 3e-7);
      const double distance = distance_to(c, s.wi);
      if (distance > 0) {  // else rounding took the direction past an edge
        EXPECT_NEAR(lamp.pdf(c.p, Vec3f(0), s.wi, distance) / s.pdf, 1, 1e-5) << c.name;
      }
      // The segment ends on the near side of the exact plane, within twice the stated bound.
      const Vec3d n = normalize(cross(Vec3d(c.vertices[1]) - Vec3d(c.vertices[0]),
                                      Vec3d(c.vertices[2]) - Vec3d(c.vertices[0])));
      const auto height = [&](const Vec3d& p) { return dot(n, p - Vec3d(c.vertices[0])); };
      const double side = height(Vec3d(c.p)) < 0 ? -1 : 1;
      const Vec3d end = Vec3d(s.shadow_ray.origin) + Vec3d(s.shadow_ray.direction);
      EXPECT_GE(side * height(end), 0) << c.name;
      EXPECT_LE(side * height(end), 2 * static_cast<double>(light.offset)) << c.name;
    }
  }
}

TEST(Unit_TriangleLight, EmitsOnTheSideOfItsWindingOrOnBoth) {
  const std::array<Vec3f, 3> vertices{Vec3f(0), {1, 0, 0}, {0, 1, 0}};
  const Light one = make_triangle_light(vertices, Rgb(2), false);
  EXPECT_EQ(triangle_light_radiance(one, {0, 0, 1}), Rgb(2));
  EXPECT_EQ(triangle_light_radiance(one, {0, 0, -1}), Rgb(0));
  EXPECT_TRUE(sample_light({}, one, light_test::at({0, 0, 1}), {0.5f, 0.25f}).is_valid());
  EXPECT_FALSE(sample_light({}, one, light_test::at({0, 0, -1}), {0.5f, 0.25f}).is_valid());
  const Light both = make_triangle_light(vertices, Rgb(2), true);
  EXPECT_EQ(triangle_light_radiance(both, {0, 0, -1}), Rgb(2));
  EXPECT_TRUE(sample_light({}, both, light_test::at({0, 0, -1}), {0.5f, 0.25f}).is_valid());
}

TEST(Statistical_TriangleLight, RectangleOverPlaneGivesLambertsIrradiance) {
  const std::array<Vec3f, 4> corners{
      Vec3f(-1, 2, -0.5f), {1, 2, -0.5f}, {1, 2, 0.5f}, {-1, 2, 0.5f}};
  const Vec3f p(0.7f, 0, 0.9f);
  const Vec3f n(0, 1, 0);
  const Light halves[2] = {make_triangle_light({corners[0], corners[1], corners[2]}, Rgb(3), true),
                           make_triangle_light({corners[0], corners[2], corners[3]}, Rgb(3), true)};
  statistics::Moments moments;
  for (std::uint64_t i = 0; i < 1'000'000; ++i) {
    double estimate = 0;
    for (std::uint64_t half = 0; half < 2; ++half) {
      const LightSample s =
          sample_light({}, halves[half], light_test::at(p), light_test::random_pair(i, 10 + half));
      estimate += static_cast<double>(s.radiance.x * std::max(0.0f, dot(n, s.wi)) / s.pdf);
    }
    moments.add(estimate);
  }
  const double exact = 3 * light_test::lambert_irradiance({Vec3d(corners[0]), Vec3d(corners[1]),
                                                           Vec3d(corners[2]), Vec3d(corners[3])},
                                                          Vec3d(p), Vec3d(n));
  EXPECT_GT(moments.p_value(exact), 1e-4)
      << moments.mean() << " +- " << moments.standard_error() << ", exact " << exact;
  EXPECT_LT(moments.standard_error() / exact, 1e-3);  // sharp enough to see a dimming by 1 %
}

// Points in the light's plane, on its vertices and edges, and right above: no NaN, no Inf.
TEST(Unit_TriangleLight, StaysFiniteWhereItGrazesOrTouches) {
  const Light light = make_triangle_light({Vec3f(0), {1, 0, 0}, {0, 1, 0}}, Rgb(5), true);
  const light_test::MetLamp lamp(light);
  const Vec3f points[] = {{0, 0, 0},     {1, 0, 0},        {0.25f, 0.25f, 0},
                          {5, 5, 0},     {2, 0, 1e-38f},   {0.3f, 0.3f, 1e-30f},
                          {2, 0, 1e-7f}, {-1, -1, -1e-20f}};
  light_test::expect_finite_samples(light, points, 10'000);
  EXPECT_EQ(light_test::MetLamp(light).pdf(Vec3f(0), Vec3f(0), {1, 0, 0}, 2),
            0.0f);  // along the plane
}

// What compiling drops has no area; what it keeps has a density that is a number.
TEST(Unit_TriangleLight, NeedlesKeepTheirAreaAndDegenerateOnesHaveNone) {
  EXPECT_EQ(make_triangle_light({Vec3f(1), Vec3f(1), Vec3f(1)}, Rgb(1), true).area, 0.0f);
  EXPECT_EQ(make_triangle_light({Vec3f(0), {1, 1, 1}, {3, 3, 3}}, Rgb(1), true).area, 0.0f);
  EXPECT_EQ(make_triangle_light({Vec3f(0), {1e-25f, 0, 0}, {0, 1e-25f, 0}}, Rgb(1), true).area,
            0.0f);
  for (const float width : {1e-3f, 1e-7f, 1e-15f, 1e-30f}) {
    const Light needle = make_triangle_light({Vec3f(0), {1, 0, 0}, {0, width, 0}}, Rgb(1), true);
    EXPECT_NEAR(needle.area / width, 0.5f, 1e-6f);
    EXPECT_EQ(needle.normal, Vec3f(0, 0, 1));
    const LightSample s = sample_light({}, needle, light_test::at({0, 0, 2}), {0.3f, 0.6f});
    ASSERT_TRUE(std::isfinite(s.pdf) && s.is_valid()) << width;
    EXPECT_TRUE(is_finite(s.radiance / s.pdf));
  }
}

}  // namespace
}  // namespace candela
