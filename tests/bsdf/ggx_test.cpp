#include "renderer/bsdf/ggx.h"

#include <gtest/gtest.h>

#include "renderer/sampling/sobol.h"
#include "tests/bsdf/bsdf_cases.h"
#include "tests/statistics/direction_sampling.h"
#include "tests/statistics/distributions.h"

namespace candela {
namespace {

using statistics::DirectionGrid;
using statistics::integrate_sphere;
using tests::direction_of;

// D as REPORT 3.7 prints it, in double.
double printed_distribution(double cos_h, double a) {
  const double base = cos_h * cos_h * (a * a - 1) + 1;
  return a * a / (pi_double * base * base);
}

TEST(Unit_Ggx, DistributionIsThePrintedOne) {
  for (const float a : {0.02f, 0.3f, 1.0f})
    for (int i = 1; i <= 100; ++i) {
      const Vec3f h = direction_of(static_cast<float>(i) / 100, 1);
      const double expected = printed_distribution(h.z, a);
      ASSERT_NEAR(ggx_distribution(h, a), expected, 1e-5 / (a * a) * expected);
      ASSERT_NEAR(ggx_distribution(h * 0.37f, a), ggx_distribution(h, a), 1e-4 * expected);
    }
}

TEST(Unit_Ggx, ProjectedAreaIsOne) {
  for (const float a : {0.01f, 0.1f, 0.5f, 1.0f}) {
    const auto projected = [a](const Vec3f& h) {
      return h.z > 0 ? double{h.z * ggx_distribution(h, a)} : 0.0;
    };
    EXPECT_NEAR(integrate_sphere(projected, {.power = 4}), 1, 2e-5) << a;
  }
}

// Visible area of the microfacets = the projection of the surface: what defines G1.
TEST(Unit_Ggx, VisibleAreaIsTheCosine) {
  for (const float a : {0.05f, 0.3f, 1.0f})
    for (const float cos_o : {0.1f, 0.5f, 0.9f}) {
      const Vec3f wo = direction_of(cos_o, 0);
      const auto visible = [&](const Vec3f& h) {
        return h.z > 0 ? std::max(0.0f, dot(wo, h)) * double{ggx_distribution(h, a)} : 0.0;
      };
      EXPECT_NEAR(integrate_sphere(visible, {.power = 3}) * smith_g1(cos_o, a), cos_o, 3e-4);
    }
}

TEST(Statistical_Ggx, VisibleNormalsFollowTheirDensity) {
  const std::array<float, 3> widths = {0.05f, 0.4f, 1.0f};
  const std::array<float, 3> cosines = {0.05f, 0.5f, 1.0f};
  const double level = statistics::sidak_level(0.01, 9);
  for (const float a : widths)
    for (const float cos_o : cosines) {
      const Vec3f wo = direction_of(cos_o, 2);
      const auto result = statistics::test_directions(
          [&](float, Vec2f u) -> std::optional<Vec3f> {
            return sample_ggx_visible_normal(wo, a, u);
          },
          [&](const Vec3f& h) {
            if (!(h.z > 0) || !(dot(wo, h) > 0)) return 0.0;
            return double{ggx_visible_normal_pdf(ggx_distribution(h, a), dot(wo, h), cos_o, a)};
          },
          {.power = a < 0.2f ? 3.0 : 1.0}, 5, 300'000);
      EXPECT_GT(result.chi_square.p_value, level) << a << " " << cos_o;
      EXPECT_NEAR(result.integral, 1, 1e-4) << a << " " << cos_o;
    }
}

// The bounded cap keeps all reflections above the surface and drops most of the others.
TEST(Unit_Ggx, BoundedSamplingRejectsLess) {
  for (const float a : {0.1f, 0.5f, 1.0f})
    for (const float cos_o : {0.1f, 0.5f, 0.9f}) {
      const Vec3f wo = direction_of(cos_o, 0);
      int bounded = 0;
      int unbounded = 0;
      for (std::uint32_t i = 0; i < 8192; ++i) {
        const Vec2f u = owen_sobol_2d(i, 9);
        if (sample_ggx_reflection(wo, a, u).z > 0) ++bounded;
        const Vec3f m = sample_ggx_visible_normal(wo, a, u);
        if ((m * (2 * dot(wo, m)) - wo).z > 0) ++unbounded;
      }
      EXPECT_GE(bounded, unbounded);
      if (a == 0.5f && cos_o == 0.1f) {
        EXPECT_GT(bounded, unbounded + 200);
      }
    }
}

}  // namespace
}  // namespace candela
