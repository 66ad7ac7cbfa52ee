// The tables' microfacets in double against those that pictures are made of, in float.
#include "renderer/bsdf/table_microfacets.h"

#include <gtest/gtest.h>

#include "renderer/bsdf/ggx.h"
#include "renderer/sampling/sobol.h"

namespace candela {
namespace {

Vec3f direction_at(double cosine) {
  return Vec3f(Vec3d(sine_of(cosine), 0, cosine));
}

template <class Check>
void for_each_normal(const Check& check) {
  for (const double a : {0.02, 0.3, 1.0})
    for (const double cosine : {0.05, 0.5, 1.0})
      for (std::uint32_t i = 0; i < 64; ++i) check(cosine, a, owen_sobol_2d(i, 3));
}

TEST(Unit_TableMicrofacets, NormalsAreThoseOfPictures) {
  for_each_normal([](double cosine, double a, Vec2f u) {
    const Vec3d here = visible_normal(cosine, a, double{u.x}, double{u.y});
    const Vec3f there = sample_ggx_visible_normal(direction_at(cosine), static_cast<float>(a), u);
    ASSERT_LT(length(here - Vec3d(there)), 2e-5) << cosine << ' ' << a;
  });
  EXPECT_EQ(visible_normal(0.3, 0, 0.2, 0.7), Vec3d(0, 0, 1)) << "of a flat surface";
}

// G2 / G1, both from [Heitz14]: 1 / (1 + L(o) + L(i)) over 1 / (1 + L(o)).
TEST(Unit_TableMicrofacets, MaskingIsThatOfPictures) {
  for (const double a : {0.01, 0.3, 1.0})
    for (const double o : {0.02, 0.4, 1.0})
      for (const double i : {0.02, 0.4, 1.0}) {
        const double g1_o = double{smith_g1(static_cast<float>(o), static_cast<float>(a))};
        const double g1_i = double{smith_g1(static_cast<float>(i), static_cast<float>(a))};
        const double g2 = 1 / (1 / g1_o + 1 / g1_i - 1);
        EXPECT_NEAR(1 - masked_share(o, i, a), g2 / g1_o, 1e-6) << a << ' ' << o << ' ' << i;
      }
  EXPECT_EQ(masked_share(0.3, 0.1, 0), 0);
}

// The microfacet's plane holds o, what is mirrored and what goes through, by the law of refraction.
TEST(Unit_TableMicrofacets, LightGoesWhereSnellSays) {
  for (const double eta : {1.5, 1 / 1.5})
    for_each_normal([&](double cosine, double a, Vec2f u) {
      const Vec3d o(sine_of(cosine), 0, cosine);
      const Vec3d m = visible_normal(cosine, a, double{u.x}, double{u.y});
      const InterfaceSplit split = split_at_microfacet(cosine, m, eta);
      ASSERT_NEAR(split.cos_reflected, (2 * dot(o, m) * m - o).z, 1e-12);
      ASSERT_NEAR(split.cos_reflected, cosine_of_reflected(cosine, m), 0);
      const Vec3d along = (o - m * dot(o, m)) / -eta;  // its part of a unit direction beyond
      const double across2 = 1 - dot(along, along);
      if (across2 <= 0) {
        ASSERT_EQ(split.reflectance, 1);
        ASSERT_EQ(split.cos_transmitted, 0);
        return;
      }
      ASSERT_NEAR(split.cos_transmitted, -(along - m * std::sqrt(across2)).z, 1e-9);
    });
  EXPECT_NEAR(split_at_microfacet(1, Vec3d(0, 0, 1), 1.5).reflectance, 0.04, 1e-7);
}

// From above, visible normals have the density D(m) m.z: the mean of m.z is the integral of
// 2 a^2 c^2 / (1 - b c^2)^2 over (0, 1), with b = 1 - a^2.
double mean_height_from_above(double a) {
  const double root = std::sqrt(1 - a * a);
  return root == 0 ? 2.0 / 3 : (1 - a * a * std::atanh(root) / root) / (root * root);
}

TEST(Unit_TableMicrofacets, MeansAreOfAllVisibleNormals) {
  const auto mean_height = [](double cosine, double a) {
    return mean_over_visible_normals<21, 64>(cosine, a, [](const Vec3d& m) { return m.z; });
  };
  for (const double a : {0.1, 0.5, 1.0})
    EXPECT_NEAR(mean_height(1, a), mean_height_from_above(a), 2e-5) << a;
  EXPECT_EQ(mean_height(0.3, 0), 1) << "of a flat surface";
  constexpr std::uint32_t samples = 1 << 16;
  double sum = 0;
  for (std::uint32_t i = 0; i < samples; ++i)
    sum += double{sample_ggx_visible_normal(direction_at(0.3), 0.5f, owen_sobol_2d(i, 3)).z};
  EXPECT_NEAR(mean_height(0.3, 0.5), sum / samples, 1e-4);
}

}  // namespace
}  // namespace candela
