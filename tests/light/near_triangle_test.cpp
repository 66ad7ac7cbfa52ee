#include "renderer/light/near_triangle.h"

#include <gtest/gtest.h>

#include "renderer/light/make_light.h"
#include "renderer/light/sample_light.h"
#include "tests/light/directions.h"
#include "tests/light/finite_samples.h"
#include "tests/light/met_lamp.h"
#include "tests/statistics/distributions.h"

namespace candela {
namespace {

using Vertices = std::array<Vec3f, 3>;

struct TriangleCase {
  const char* name;
  Vertices vertices;
  Vec3f p;
  Vec3f normal;  // the receiver's; 0: none
};

const Vertices wide{Vec3f(-1, -1, 2), {1, -1, 2}, {0, 1.2f, 2}};
const Vertices needle{Vec3f(0, -0.05f, 1), {10, 0, 1}, {0, 0.05f, 1}};

const std::vector<TriangleCase>& cases() {
  static const std::vector<TriangleCase> all{
      {"facing", wide, {0, 0, 1}, {0, 0, 1}},
      {"no surface", wide, {0.3f, 0.2f, 1.5f}, Vec3f(0)},
      {"aslant", wide, {0.9f, 0, 1.3f}, normalize(Vec3f(-1, 0.5f, 0.2f))},
      {"partly below the surface", wide, {0.2f, 0, 1.2f}, {1, 0, 0}},
      {"nearly all of a hemisphere", wide, {0, -0.1f, 1.999f}, {0, 0, 1}},
      {"beside an edge", wide, {0.1f, -1.001f, 1.99f}, {0, 0, 1}},
      {"beside a vertex", wide, {-1.01f, -1.002f, 1.98f}, {0, 0, 1}},
      {"beside it, grazing", wide, {0.9f, 0.2f, 1.8f}, normalize(Vec3f(-1, 0, 0.1f))},
      {"a wall that it touches", wide, {0.2f, -1, 1.6f}, {0, 1, 0}},
      {"needle, beside its blunt end", needle, {0.1f, 0, 0.9f}, {0, 0, 1}},
      {"needle, beside its point", needle, {9, 0, 0.99f}, normalize(Vec3f(-1, 0, 1))},
      {"far", wide, {0, 0, -20}, {0, 0, 1}},
  };
  return all;
}

Light light_of(const Vertices& vertices, bool by_solid_angle = true) {
  Light light = make_triangle_light(vertices, Rgb(1, 2, 3), true);
  if (by_solid_angle) sample_by_solid_angle(light, 0);
  return light;
}

SurfacePoint receiver(const Vec3f& p, const Vec3f& normal) {
  SurfacePoint point = light_test::at(p);
  point.receiving_normal = normal;
  return point;
}

LightSample sample(const TriangleCase& c, const Light& light, Vec2f u) {
  return sample_light({}, light, receiver(c.p, c.normal), u);
}

// Where the ray from p along d meets the triangle, in double; 0 where it does not.
double distance_to(const TriangleCase& c, const Vec3d& d) {
  const Vec3d e1 = Vec3d(c.vertices[1]) - Vec3d(c.vertices[0]);
  const Vec3d e2 = Vec3d(c.vertices[2]) - Vec3d(c.vertices[0]);
  const Vec3d s = Vec3d(c.p) - Vec3d(c.vertices[0]);
  const Vec3d h = cross(d, e2);
  const double determinant = dot(e1, h);
  const double u = dot(s, h) / determinant;
  const Vec3d q = cross(s, e1);
  const double v = dot(d, q) / determinant;
  const double t = dot(e2, q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : 0;
}

double pdf_towards(const TriangleCase& c, const light_test::MetLamp& lamp, const Vec3f& d) {
  const double t = distance_to(c, Vec3d(d));
  if (!(t > 0)) return 0;
  return static_cast<double>(lamp.pdf(c.p, c.normal, d, t));
}

// Nothing of the near ones is outside of a hemisphere about their plane's normal.
light_test::Cap cap_of(const TriangleCase& c) {
  const bool is_far = c.p.z < -1;
  return {frame_from_normal({0, 0, 1}), is_far ? 0.995 : 0.0};
}

TEST(Unit_NearTriangle, AreThoseThatAreSeenLarge) {
  for (const TriangleCase& c : cases()) {
    const LightSample near = sample(c, light_of(c.vertices), {0.3f, 0.6f});
    const LightSample area = sample(c, light_of(c.vertices, false), {0.3f, 0.6f});
    EXPECT_EQ(near.pdf == area.pdf, std::string(c.name) == "far") << c.name;
  }
}

TEST(Statistical_NearTriangle, DensityIntegratesToOne) {
  for (const TriangleCase& c : cases()) {
    const Light light = light_of(c.vertices);
    const light_test::MetLamp lamp(light);
    const statistics::Moments sum = light_test::random_integral(
        cap_of(c), 500'000, [&](const Vec3f& d) { return pdf_towards(c, lamp, d); });
    EXPECT_GT(sum.p_value(1), 1e-4) << c.name << ": " << sum.mean();
    EXPECT_LT(sum.standard_error(), 0.02) << c.name;
  }
}

TEST(Statistical_NearTriangle, SamplesFitTheDensity) {
  for (const TriangleCase& c : cases()) {
    const Light light = light_of(c.vertices);
    const light_test::MetLamp lamp(light);
    const auto direction = [&](Vec2f u) -> std::optional<Vec3f> { return sample(c, light, u).wi; };
    const double p_value = light_test::chi_square_p_value(
        cap_of(c), 60, 300'000, direction, [&](const Vec3f& d) { return pdf_towards(c, lamp, d); });
    EXPECT_GT(p_value, statistics::sidak_level(0.01, static_cast<double>(cases().size())))
        << c.name;
  }
}

// Of values that depend on the place: the mean over samples of f / pdf is the integral of f, which
// plain samples by area tell as well.
TEST(Statistical_NearTriangle, SamplesAreWeightedByTheirDensity) {
  for (const TriangleCase& c : cases()) {
    const auto estimate = [&](const Light& light, std::uint64_t stream) {
      statistics::Moments moments;
      for (std::uint64_t i = 0; i < 300'000; ++i) {
        const LightSample s = sample(c, light, light_test::random_pair(i, stream));
        if (!s.is_valid()) {
          moments.add(0);
          continue;
        }
        const Vec3f end = s.shadow_ray.origin + s.shadow_ray.direction;
        const float f = 1 + std::sin(3 * end.x) * std::cos(2 * end.y + end.z);
        const float cosine = c.normal == Vec3f(0) ? 1.0f : std::max(dot(c.normal, s.wi), 0.0f);
        moments.add(static_cast<double>(f * cosine / s.pdf));
      }
      return moments;
    };
    const statistics::Moments near = estimate(light_of(c.vertices, true), 31);
    const statistics::Moments area = estimate(light_of(c.vertices, false), 32);
    const double error = std::hypot(near.standard_error(), area.standard_error());
    EXPECT_GT(statistics::normal_two_sided((near.mean() - area.mean()) / error), 1e-4)
        << c.name << ": " << near.mean() << " and " << area.mean() << " +- " << error;
    EXPECT_LT(near.standard_error(), 0.01 * near.mean()) << c.name;
  }
}

TEST(Unit_NearTriangle, SampleAndPdfAgreeAndEndOnTheTriangle) {
  for (const TriangleCase& c : cases()) {
    const Light light = light_of(c.vertices);
    const light_test::MetLamp lamp(light);
    int compared = 0;
    for (std::uint64_t i = 0; i < 1000; ++i) {
      const LightSample s = sample(c, light, light_test::random_pair(i, 3));
      ASSERT_TRUE(s.is_valid()) << c.name;
      EXPECT_EQ(s.radiance, Rgb(1, 2, 3));
      EXPECT_NEAR(length(s.wi), 1, 3e-7);
      if (!(distance_to(c, Vec3d(s.wi)) > 0)) continue;  // rounding took it past an edge
      ++compared;
      EXPECT_NEAR(pdf_towards(c, lamp, s.wi) / static_cast<double>(s.pdf), 1, 3e-3) << c.name;
    }
    EXPECT_GT(compared, 900) << c.name;
  }
}

// What a white surface gets: with the cosine's warp there is little noise left of a lamp overhead.
TEST(Statistical_NearTriangle, GivesLambertsIrradiance) {
  for (const float height : {1.0f, 0.1f, 0.003f}) {
    const Light light = light_of(wide);
    const SurfacePoint point = receiver({0.1f, -0.3f, 2 - height}, {0, 0, 1});
    statistics::Moments moments;
    for (std::uint64_t i = 0; i < 200'000; ++i) {
      const LightSample s = sample_light({}, light, point, light_test::random_pair(i, 17));
      moments.add(static_cast<double>(std::max(s.wi.z, 0.0f) / s.pdf));
    }
    const std::vector<Vec3d> polygon{Vec3d(wide[0]), Vec3d(wide[1]), Vec3d(wide[2])};
    const double exact =
        light_test::lambert_irradiance(polygon, Vec3d(point.position), Vec3d(0, 0, 1));
    EXPECT_GT(moments.p_value(exact), 1e-4)
        << height << ": " << moments.mean() << " +- " << moments.standard_error() << ", " << exact;
    EXPECT_LT(moments.standard_error() / exact, 2e-3) << height;
  }
}

TEST(Unit_NearTriangle, ShinesOnTheSideOfItsWindingOrOnBoth) {
  for (const bool emits_both_sides : {false, true}) {
    Light light = make_triangle_light(wide, Rgb(2), emits_both_sides);
    sample_by_solid_angle(light, 0);
    for (const float z : {1.0f, -50.0f, 3.0f, 50.0f})
      EXPECT_EQ(sample_light({}, light, light_test::at({0.1f, 0, z}), {0.3f, 0.6f}).is_valid(),
                emits_both_sides || z > 2);
  }
}

// Points in the light's plane, on its vertices and edges, right above, and needles: no NaN, no Inf.
TEST(Unit_NearTriangle, StaysFiniteWhereItGrazesOrTouches) {
  for (const float width : {1.0f, 1e-3f, 1e-7f, 1e-15f}) {
    const Light light = light_of({Vec3f(0), {1, 0, 0}, {0, width, 0}});
    const light_test::MetLamp lamp(light);
    const Vec3f points[] = {{0, 0, 0},
                            {1, 0, 0},
                            {0, width, 0},
                            {0.25f, 0, 0},
                            {0.25f, width / 2, 0},
                            {5, 5, 0},
                            {2, 0, 1e-38f},
                            {0.3f, width / 3, 1e-30f},
                            {0.3f, 0, 1e-7f},
                            {2, 0, 1e-7f},
                            {-1, -1, -1e-20f},
                            {1e25f, 1e25f, 1e25f},
                            {0.5f, width / 4, 1e-4f}};
    light_test::expect_finite_samples(light, points);
  }
}

}  // namespace
}  // namespace candela
