#include "renderer/light/quad_light.h"

#include <gtest/gtest.h>

#include "renderer/light/make_light.h"
#include "renderer/light/sample_light.h"
#include "tests/light/directions.h"
#include "tests/light/finite_samples.h"
#include "tests/light/met_lamp.h"
#include "tests/statistics/distributions.h"

namespace candela {
namespace {

using Corners = std::array<Vec3f, 4>;

Corners corners_of(const Vec3f& corner, const Vec3f& edge1, const Vec3f& edge2) {
  return {corner, corner + edge1, corner + edge1 + edge2, corner + edge2};
}

struct QuadCase {
  const char* name;
  Corners corners;
  Vec3f p;
  Vec3f normal;  // the receiver's; 0: none
  bool is_near;
};

const Corners square = corners_of({-1, -1, 2}, {2, 0, 0}, {0, 2, 0});
const Corners skew = corners_of({-1, -1, 2}, {2, 0, 0}, {1, 2, 0});

const std::vector<QuadCase>& cases() {
  static const std::vector<QuadCase> all{
      {"facing", square, {0, 0, 0.5f}, {0, 0, 1}, true},
      {"no surface", square, {0.3f, 0.2f, 1.5f}, Vec3f(0), true},
      {"aslant", square, {1.2f, 0, 1.2f}, normalize(Vec3f(-1, 0.5f, 0.2f)), true},
      {"partly below the surface", square, {0.5f, 0.5f, 1}, {1, 0, 0}, true},
      {"nearly all of a hemisphere", square, {0.1f, 0.2f, 1.999f}, {0, 0, 1}, true},
      {"beside it, grazing", square, {1.5f, 0.2f, 1.75f}, normalize(Vec3f(-1, 0, 0.1f)), true},
      {"edge on", square, {1.4f, 0, 1.9999f}, {-1, 0, 0}, true},
      {"a wall that it touches", square, {1, 0, 1.8f}, {-1, 0, 0}, true},
      {"far", square, {0, 0, -20}, {0, 0, 1}, false},
      {"skew", skew, {0, 0, 1}, {0, 0, 1}, false},
      {"long, beside its end",
       corners_of({0, -0.05f, 1}, {10, 0, 0}, {0, 0.1f, 0}),
       {0, 0, 0.9f},
       {0, 0, 1},
       true},
  };
  return all;
}

Light light_of(const QuadCase& c, bool by_solid_angle = true) {
  return *make_quad_light(c.corners, Rgb(1, 2, 3), true, by_solid_angle);
}

SurfacePoint receiver(const QuadCase& c) {
  SurfacePoint point = light_test::at(c.p);
  point.receiving_normal = c.normal;
  return point;
}

// Where the ray from p along d meets the quad, in double; 0 where it does not.
double distance_to(const QuadCase& c, const Vec3d& d) {
  const Vec3d e1 = Vec3d(c.corners[1]) - Vec3d(c.corners[0]);
  const Vec3d e2 = Vec3d(c.corners[3]) - Vec3d(c.corners[0]);
  const Vec3d s = Vec3d(c.p) - Vec3d(c.corners[0]);
  const Vec3d h = cross(d, e2);
  const double determinant = dot(e1, h);
  const double u = dot(s, h) / determinant;
  const Vec3d q = cross(s, e1);
  const double v = dot(d, q) / determinant;
  const double t = dot(e2, q) / determinant;
  return u >= 0 && u <= 1 && v >= 0 && v <= 1 && t > 0 ? t : 0;
}

double pdf_towards(const QuadCase& c, const light_test::MetLamp& lamp, const Vec3f& d) {
  const double t = distance_to(c, Vec3d(d));
  if (!(t > 0)) return 0;
  return static_cast<double>(lamp.pdf(c.p, c.normal, d, t));
}

// What a direction's density does within the lamp is at most a few times its mean, so a cap about
// it that is not much larger than the lamp gives a sharp integral.
light_test::Cap cap_of(const QuadCase& c) {
  const Vec3f middle = (c.corners[0] + c.corners[2]) * 0.5f - c.p;
  const Vec3f axis = normalize(middle);
  double cos_min = 1;
  for (const Vec3f& corner : c.corners)
    cos_min = std::min(cos_min, static_cast<double>(dot(axis, normalize(corner - c.p))));
  // The nearest point may be further from the middle's direction than any corner.
  const bool is_close = light_of(c).near_distance2 > 0 && dot(middle, middle) < 4;
  return {frame_from_normal(axis), is_close ? -1.0 : cos_min - 1e-4};
}

TEST(Unit_QuadLight, IsNearWhereItShouldBe) {
  for (const QuadCase& c : cases()) EXPECT_EQ(is_near(light_of(c), c.p), c.is_near) << c.name;
  for (const QuadCase& c : cases()) EXPECT_FALSE(is_near(light_of(c, false), c.p)) << c.name;
}

TEST(Statistical_QuadLight, DensityIntegratesToOne) {
  for (const QuadCase& c : cases()) {
    const Light light = light_of(c);
    const light_test::MetLamp lamp(light);
    const statistics::Moments sum = light_test::random_integral(
        cap_of(c), 300'000, [&](const Vec3f& d) { return pdf_towards(c, lamp, d); });
    if (std::string(c.name) == "edge on") continue;  // 300'000 directions hardly meet it
    EXPECT_GT(sum.p_value(1), 1e-4) << c.name << ": " << sum.mean();
    EXPECT_LT(sum.standard_error(), 0.1) << c.name;
  }
}

// Of values that depend on the place: the sum over samples of f / pdf is the integral of f, which
// plain samples by area tell as well.
TEST(Statistical_QuadLight, SamplesAreWeightedByTheirDensity) {
  for (const QuadCase& c : cases()) {
    const auto estimate = [&](const Light& light, std::uint64_t stream) {
      statistics::Moments moments;
      for (std::uint64_t i = 0; i < 300'000; ++i) {
        const LightSample s =
            sample_light({}, light, receiver(c), light_test::random_pair(i, stream));
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
    const statistics::Moments near = estimate(light_of(c, true), 31);
    const statistics::Moments area = estimate(light_of(c, false), 32);
    const double error = std::hypot(near.standard_error(), area.standard_error());
    EXPECT_GT(statistics::normal_two_sided((near.mean() - area.mean()) / error), 1e-4)
        << c.name << ": " << near.mean() << " and " << area.mean() << " +- " << error;
    EXPECT_LT(near.standard_error(), 0.01 * near.mean()) << c.name;
  }
}

TEST(Unit_QuadLight, SampleAndPdfAgreeAndEndOnTheQuad) {
  for (const QuadCase& c : cases()) {
    const Light light = light_of(c);
    const light_test::MetLamp lamp(light);
    int compared = 0;
    for (std::uint64_t i = 0; i < 1000; ++i) {
      const LightSample s = sample_light({}, light, receiver(c), light_test::random_pair(i, 3));
      ASSERT_TRUE(s.is_valid()) << c.name;
      EXPECT_EQ(s.radiance, Rgb(1, 2, 3));
      EXPECT_NEAR(length(s.wi), 1, 3e-7);
      const double distance = distance_to(c, Vec3d(s.wi));
      if (!(distance > 0)) continue;  // rounding took the direction past an edge
      ++compared;
      // Grazing, what rounding does to the direction shows in the cosine and so in the density.
      EXPECT_NEAR(pdf_towards(c, lamp, s.wi) / static_cast<double>(s.pdf), 1, 3e-3) << c.name;
    }
    EXPECT_GT(compared, 900) << c.name;
  }
}

// What a white surface gets: with the cosine's warp there is little noise left of a lamp overhead.
TEST(Statistical_QuadLight, GivesLambertsIrradiance) {
  for (const float height : {1.0f, 0.1f, 0.003f}) {
    const Light light = *make_quad_light(square, Rgb(1), true, true);
    SurfacePoint point = light_test::at({0.4f, -0.3f, 2 - height});
    point.receiving_normal = {0, 0, 1};
    statistics::Moments moments;
    for (std::uint64_t i = 0; i < 200'000; ++i) {
      const LightSample s = sample_light({}, light, point, light_test::random_pair(i, 17));
      moments.add(static_cast<double>(std::max(s.wi.z, 0.0f) / s.pdf));
    }
    const std::vector<Vec3d> polygon{Vec3d(square[0]), Vec3d(square[1]), Vec3d(square[2]),
                                     Vec3d(square[3])};
    const double exact =
        light_test::lambert_irradiance(polygon, Vec3d(point.position), Vec3d(0, 0, 1));
    EXPECT_GT(moments.p_value(exact), 1e-4)
        << height << ": " << moments.mean() << " +- " << moments.standard_error() << ", " << exact;
    EXPECT_LT(moments.standard_error() / exact, 2e-3) << height;
  }
}

TEST(Unit_QuadLight, ShinesOnTheSideOfItsWindingOrOnBoth) {
  const Light one = *make_quad_light(square, Rgb(2), false, true);
  for (const float z : {1.0f, -50.0f, 3.0f, 50.0f}) {
    const bool is_lit = z > 2;
    EXPECT_EQ(sample_light({}, one, light_test::at({0.1f, 0, z}), {0.3f, 0.6f}).is_valid(), is_lit);
  }
  const Light both = *make_quad_light(square, Rgb(2), true, true);
  for (const float z : {1.0f, -50.0f, 3.0f, 50.0f})
    EXPECT_TRUE(sample_light({}, both, light_test::at({0.1f, 0, z}), {0.3f, 0.6f}).is_valid());
}

// Points in the light's plane, on its corners and edges, right above, and needles: no NaN, no Inf.
TEST(Unit_QuadLight, StaysFiniteWhereItGrazesOrTouches) {
  for (const float width : {1.0f, 1e-3f, 1e-7f, 1e-15f}) {
    const Light light =
        *make_quad_light(corners_of(Vec3f(0), {1, 0, 0}, {0, width, 0}), Rgb(5), true, true);
    const Vec3f points[] = {{0, 0, 0},
                            {1, 0, 0},
                            {1, width, 0},
                            {0.25f, 0, 0},
                            {0.25f, width / 2, 0},
                            {5, 5, 0},
                            {2, 0, 1e-38f},
                            {0.3f, width / 3, 1e-30f},
                            {0.3f, 0, 1e-7f},
                            {2, 0, 1e-7f},
                            {-1, -1, -1e-20f},
                            {0.5f, width / 2, 1e-4f}};
    light_test::expect_finite_samples(light, points);
  }
}

// From 1e-12 sr to 2 pi the mean of 1 / pdf is the solid angle.
TEST(Statistical_QuadLight, KnowsItsSolidAngleFromFarToTouching) {
  for (const float height : {1e6f, 1e3f, 30.0f, 4.6f, 4.4f, 1.0f, 0.1f, 1e-3f, 1e-5f}) {
    const Light light = *make_quad_light(square, Rgb(1), true, true);
    const light_test::MetLamp lamp(light);
    statistics::Moments moments;
    for (std::uint64_t i = 0; i < 20'000; ++i) {
      const LightSample s = sample_light({}, light, light_test::at({0, 0, 2 + height}),
                                         light_test::random_pair(i, 9));
      moments.add(1 / static_cast<double>(s.pdf));
    }
    const double h = static_cast<double>(2 + height) - 2;
    const double exact = 4 * std::atan2(1.0, h * std::sqrt(2 + h * h));
    EXPECT_NEAR(moments.mean() / exact, 1, 1e-5 + 5 * moments.standard_error() / exact) << height;
  }
}

TEST(Unit_QuadLight, IsMadeOfParallelogramsOnly) {
  Corners trapezium = square;
  trapezium[2].x += 1e-3f;
  EXPECT_FALSE(make_quad_light(trapezium, Rgb(1), true, true));
  Corners bent = square;
  bent[2].z += 1e-3f;
  EXPECT_FALSE(make_quad_light(bent, Rgb(1), true, true));
  Corners rounded = square;
  rounded[2].x = std::nextafter(rounded[2].x, 2.0f);
  EXPECT_TRUE(make_quad_light(rounded, Rgb(1), true, true));
  EXPECT_FALSE(make_quad_light(corners_of(Vec3f(1), Vec3f(0), {0, 1, 0}), Rgb(1), true, true));
  EXPECT_EQ(make_quad_light(square, Rgb(1), true, true)->area, 4);
}

}  // namespace
}  // namespace candela
