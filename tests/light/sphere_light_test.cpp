#include "renderer/light/sphere_light.h"

#include <gtest/gtest.h>

#include "renderer/accel/sphere_hit.h"
#include "renderer/light/make_light.h"
#include "renderer/light/sample_light.h"
#include "tests/light/directions.h"
#include "tests/statistics/distributions.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using light_test::Cap;

struct SphereCase {
  const char* name;
  Sphere sphere;
  Vec3f p;
};

Sphere sphere_at(const Vec3f& centre, float radius) {
  Sphere sphere;
  sphere.centre = centre;
  sphere.radius = radius;
  return sphere;
}

const std::vector<SphereCase>& cases() {
  static const std::vector<SphereCase> all{
      {"ordinary", sphere_at({1, 2, -1}, 0.7f), {0.5f, 0, 0}},
      {"far", sphere_at({0, 300, 400}, 1), {0.2f, 0.1f, 0}},
      {"near", sphere_at({0, 0, 0}, 1), {0.6f, 0.8003f, 0}},
      {"tiny units", sphere_at({3e-9f, 0, 1e-9f}, 1e-9f), {0, 0, 0}},
      {"within", sphere_at({0, 0, 0}, 1), {0.3f, 0.2f, -0.4f}},
      {"within, near", sphere_at({0, 0, 0}, 1), {0.59f, 0.79f, 0}},
  };
  return all;
}

bool is_outside(const SphereCase& c) {
  return length(Vec3d(c.p) - Vec3d(c.sphere.centre)) > static_cast<double>(c.sphere.radius);
}

// A cap about the centre a little wider than the sphere; from within all directions.
Cap cap_of(const SphereCase& c) {
  if (!is_outside(c)) return {};
  const Vec3d to_centre = Vec3d(c.sphere.centre) - Vec3d(c.p);
  const double ratio = static_cast<double>(c.sphere.radius) / length(to_centre);
  const double cosine = std::sqrt((1 - ratio) * (1 + ratio));
  return {frame_from_normal(Vec3f(normalize(to_centre))), 1 - 1.1 * (1 - cosine)};
}

double pdf_towards(const SphereCase& c, const Light& light, const Vec3f& d) {
  const SphereHit hit =
      intersect_sphere(c.sphere, {c.p, d, infinity}, infinity, [](float, float) { return true; });
  if (!hit.is_hit()) return 0;
  return static_cast<double>(sphere_light_pdf(light, from_octahedron({hit.u, hit.v}), d, hit.t));
}

LightSample sample_at(const Light& light, const Vec3f& p, Vec2f u) {
  static const std::vector<Geometry> no_geometries;
  static const TextureStore no_textures;
  return sample_light({nullptr, &no_textures, &no_geometries}, light, light_test::at(p), u);
}

TEST(Statistical_SphereLight, DensityIntegratesToOne) {
  for (const SphereCase& c : cases()) {
    const Light light = make_sphere_light(c.sphere, Rgb(1), true);
    const statistics::Moments sum = light_test::random_integral(
        cap_of(c), 300'000, [&](const Vec3f& d) { return pdf_towards(c, light, d); });
    EXPECT_GT(sum.p_value(1), 1e-4) << c.name << ": " << sum.mean();
    EXPECT_LT(sum.standard_error(), 0.01) << c.name;
  }
}

TEST(Statistical_SphereLight, SamplesFitTheDensity) {
  for (const SphereCase& c : cases()) {
    const Light light = make_sphere_light(c.sphere, Rgb(1), true);
    const double p_value = light_test::chi_square_p_value(
        cap_of(c), 40, 300'000,
        [&](Vec2f u) -> std::optional<Vec3f> { return sample_at(light, c.p, u).wi; },
        [&](const Vec3f& d) { return pdf_towards(c, light, d); });
    EXPECT_GT(p_value, statistics::sidak_level(0.01, static_cast<double>(cases().size())))
        << c.name;
  }
}

TEST(Unit_SphereLight, SampleAndPdfAgreeAndEndOutsideOfIt) {
  for (const SphereCase& c : cases()) {
    const Light light = make_sphere_light(c.sphere, Rgb(1, 2, 3), true);
    const auto radius = static_cast<double>(c.sphere.radius);
    for (std::uint64_t i = 0; i < 2000; ++i) {
      const LightSample s = sample_at(light, c.p, light_test::random_pair(i, 3));
      ASSERT_TRUE(s.is_valid()) << c.name;
      EXPECT_EQ(s.radiance, Rgb(1, 2, 3));
      EXPECT_NEAR(length(s.wi), 1, 3e-7);
      const double met = pdf_towards(c, light, s.wi);
      if (met > 0) {  // else rounding took the direction past the limb
        EXPECT_NEAR(met / static_cast<double>(s.pdf), 1, is_outside(c) ? 2e-5 : 1e-3) << c.name;
      }
      // It ends just off the surface, on the side of p, and meets nothing on its way.
      const Vec3d end = Vec3d(s.shadow_ray.origin) + Vec3d(s.shadow_ray.direction);
      const double height = length(end - Vec3d(c.sphere.centre)) - radius;
      EXPECT_GT(is_outside(c) ? height : -height, 0) << c.name;
      EXPECT_LT(std::abs(height), 2 * static_cast<double>(light.offset)) << c.name;
      EXPECT_FALSE(intersect_sphere(c.sphere, s.shadow_ray, s.shadow_ray.t_max,
                                    [](float, float) { return true; })
                       .is_hit())
          << c.name;
    }
  }
}

// 2 pi (1 - cos) of the cone, in long double.
long double solid_angle(const Sphere& sphere, const Vec3f& p) {
  long double distance2 = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const long double d =
        static_cast<long double>(sphere.centre[axis]) - static_cast<long double>(p[axis]);
    distance2 += d * d;
  }
  const long double sine2 =
      static_cast<long double>(sphere.radius) * static_cast<long double>(sphere.radius) / distance2;
  return 2 * 3.14159265358979323846L * sine2 / (1 + std::sqrt(1 - sine2));
}

// From 10^-12 sr to nearly 2 pi: the density is one over the solid angle, sampled and met.
TEST(Unit_SphereLight, DensityIsStableForAllSolidAngles) {
  for (int k = 0; k <= 48; ++k) {
    const float distance =
        k <= 24 ? 1 + std::pow(10.0f, -k / 6.0f) : std::pow(10.0f, (k - 24) / 4.0f);
    const Sphere sphere = sphere_at({0, 0, 0}, 0.5f);
    const Vec3f p = Vec3f(0.6f, 0, 0.8f) * (0.5f * distance);
    const Light light = make_sphere_light(sphere, Rgb(1), false);
    const long double expected = solid_angle(sphere, p);
    const LightSample s = sample_at(light, p, {0.3f, 0.7f});
    ASSERT_TRUE(s.is_valid()) << distance;
    EXPECT_NEAR(static_cast<double>(s.pdf * expected), 1, 2e-7) << distance;
    const double met = pdf_towards({"", sphere, p}, light, s.wi);
    if (distance < 1e5f) {
      ASSERT_GT(met, 0) << distance;
    }
    if (met > 0) {
      EXPECT_NEAR(met * static_cast<double>(expected), 1, 1e-4) << distance;
    }
  }
}

TEST(Unit_SphereLight, ShinesOnItsSide) {
  const Vec3f p{2, 0, 0};
  const Vec3f within{0.5f, 0, 0};
  Sphere sphere;
  const auto shines = [&](const Vec3f& from, bool both) {
    const Light light = make_sphere_light(sphere, Rgb(1), both);
    return sample_at(light, from, {0.4f, 0.6f}).is_valid();
  };
  EXPECT_TRUE(shines(p, false));
  EXPECT_FALSE(shines(within, false));
  sphere.faces_inwards = true;
  EXPECT_FALSE(shines(p, false));
  EXPECT_TRUE(shines(within, false));
  EXPECT_TRUE(shines(p, true));
  EXPECT_TRUE(shines(within, true));
}

// Its far side, through a hole of the near one, only paths find.
TEST(Unit_SphereLight, TheFarSideIsNotSampledFromOutside) {
  const Light light = make_sphere_light({}, Rgb(1), true);
  const Vec3f wi{0, 0, 1};
  EXPECT_GT(sphere_light_pdf(light, {0, 0, -1}, wi, 1), 0.0f);
  EXPECT_EQ(sphere_light_pdf(light, {0, 0, 1}, wi, 3), 0.0f);
}

// What lies on the sphere itself sees nothing of its outside: rounding must not make it a cone.
TEST(Unit_SphereLight, PointsOnItSeeNothingOfItsOutside) {
  const Sphere sphere = sphere_at({0.3f, -0.8f, 0.5f}, 0.01f);
  const Light light = make_sphere_light(sphere, Rgb(1), false);
  int lit = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Vec3f n = light_test::random_direction(i, 5);
    lit += sample_at(light, sphere.centre + n * sphere.radius, light_test::random_pair(i, 6))
               .is_valid();
  }
  EXPECT_LT(lit, 10);
}

// Rays that may meet it start a little nearer to it than the surface that they leave lies.
TEST(Unit_SphereLight, SamplesSeeItFromWhereRaysStart) {
  const Sphere sphere;
  const Light light = make_sphere_light(sphere, Rgb(1), true);
  const std::vector<Geometry> no_geometries;
  const TextureStore no_textures;
  SurfacePoint from;
  from.geometric_normal = {0, 1, 0};
  from.offset = 1e-6f;
  int compared = 0;
  for (float gap = 5e-7f; gap < 1e-5f; gap *= 1.03f) {
    from.position = {0, -1 - gap, 0};
    for (std::uint64_t i = 0; i < 20; ++i) {
      const LightSample s = sample_light({nullptr, &no_textures, &no_geometries}, light, from,
                                         light_test::random_pair(i, 11));
      if (!s.is_valid()) continue;
      const Vec3f origin = offset_origin(from.position, from.geometric_normal, from.offset, s.wi);
      const SphereHit hit = intersect_sphere(sphere, {origin, s.wi, infinity}, infinity,
                                             [](float, float) { return true; });
      const auto meets = [](float, float) { return true; };
      if (!hit.is_hit() ||
          intersect_sphere(sphere, s.shadow_ray, s.shadow_ray.t_max, meets).is_hit())
        continue;
      const float met = sphere_light_pdf(light, from_octahedron({hit.u, hit.v}), s.wi, hit.t);
      ++compared;
      ASSERT_NEAR(met / s.pdf, 1, 0.1f) << gap;
    }
  }
  EXPECT_GT(compared, 100);
}

}  // namespace
}  // namespace candela
