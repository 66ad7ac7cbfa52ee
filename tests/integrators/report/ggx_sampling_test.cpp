// REPORT 3.9: half vectors of GGX, and the density of the directions mirrored about them.
#include <gtest/gtest.h>

#include <array>

#include "integrators/report/ggx_half_vector.h"
#include "tests/bsdf/bsdf_cases.h"
#include "tests/integrators/report/printed_formulas.h"
#include "tests/integrators/report/quadrature.h"
#include "tests/statistics/direction_sampling.h"
#include "tests/statistics/distributions.h"

namespace candela {
namespace {

using statistics::test_directions;

using tests::direction_of;
using tests::unit_integral;

struct Case {
  float a;
  float cos_o;
};
constexpr std::array cases = {Case{1, 0.9f},     Case{0.5f, 0.4f},  Case{0.3f, 0.97f},
                              Case{0.3f, 0.06f}, Case{0.1f, 0.95f}, Case{0.1f, 0.06f}};
constexpr int sample_count = 1'000'000;

statistics::DirectionGrid grid_for(const Case& c, const Vec3f& wo) {
  if (c.a > 0.2f) return {};
  return {.axis = normalize(Vec3f{-wo.x, -wo.y, wo.z}), .power = 3};
}

std::optional<Vec3f> reflection(const Vec3f& wo, float a, Vec2f u) {
  const Vec3f wi = reflect_about(wo, sample_ggx_half_vector(a, u));
  if (!(wi.z > 0)) return std::nullopt;
  return wi;
}

// pdf = p_h / (2 wo.h) of the direction wi.
double printed_pdf(const Vec3f& wo, const Vec3f& wi, float a) {
  if (!(wi.z > 0)) return 0;
  const Vec3d h = normalize(Vec3d(wo) + Vec3d(wi));
  const double theta = std::atan2(std::hypot(h.x, h.y), h.z);
  return printed::ggx_pdf(theta, a, dot(Vec3d(wo), h));
}

// The printed angle is right: the sampler of the renderer's report has it.
TEST(Statistical_ReportGgx, PrintedAngleIsTheSamplers) {
  for (const float a : {1.0f, 0.3f, 0.05f})
    for (const float xi : {0.0f, 0.1f, 0.5f, 0.9f, 0.999f}) {
      const Vec3f h = sample_ggx_half_vector(a, {xi, 0.3f});
      EXPECT_NEAR(std::atan2(std::hypot(h.x, h.y), h.z), printed::ggx_theta(xi, a), 1e-6);
    }
}

TEST(Statistical_ReportGgx, HalfVectorsFollowDTimesCosine) {
  for (const float a : {1.0f, 0.3f}) {
    const auto result = test_directions(
        [&](float, Vec2f u) { return sample_ggx_half_vector(a, u); },
        [&](const Vec3f& h) { return h.z > 0 ? printed::ggx_distribution(h.z, a) * h.z : 0.0; }, {},
        4);
    EXPECT_NEAR(result.integral, 1, 1e-4);
    EXPECT_GT(result.chi_square.p_value, 0.01) << a;
  }
}

// D (n.h) / (4 (wo.h)) integrates to the share of reflections above the surface, and they follow
// it.
TEST(Statistical_ReportGgx, CorrectedDensityIsThatOfTheDirections) {
  const double level = statistics::sidak_level(0.01, 2.0 * cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto [a, cos_o] = cases[i];
    SCOPED_TRACE(testing::Message() << "a " << a << " cosine " << cos_o);
    const Vec3f wo = direction_of(cos_o, 0.7f);
    const auto result = test_directions(
        [&, a = a](float, Vec2f u) { return reflection(wo, a, u); },
        [&, a = a](const Vec3f& wi) { return double{ggx_half_vector_pdf(wo, wi, a)}; },
        grid_for(cases[i], wo), 10 + i, sample_count);
    EXPECT_GT(result.chi_square.p_value, level) << result.chi_square.statistic;
    const double share = std::min(1.0, result.integral);
    const double error = std::sqrt(std::max(1e-8, share * (1 - share) / sample_count));
    EXPECT_LT(std::abs(result.accepted_fraction - share),
              error * statistics::normal_quantile(1 - level / 2));
  }
}

// p_h / (2 (wo.h)) is 2 sin(theta_h) times the density: its integral is not the share of accepted
// directions, though for a = 1 it comes within 1 % by luck.
TEST(Statistical_ReportGgx, PrintedDensityIsNotThatOfTheDirections) {
  for (const Case& c : cases) {
    SCOPED_TRACE(testing::Message() << "a " << c.a << " cosine " << c.cos_o);
    const Vec3f wo = direction_of(c.cos_o, 0.7f);
    const auto result = test_directions([&](float, Vec2f u) { return reflection(wo, c.a, u); },
                                        [&](const Vec3f& wi) { return printed_pdf(wo, wi, c.a); },
                                        grid_for(c, wo), 20, 100'000);
    EXPECT_LT(result.chi_square.p_value, 1e-30);
    EXPECT_GT(std::abs(result.integral - result.accepted_fraction), 0.005);
  }
}

// The mean of (true density / printed density) = 1 / (2 sin theta_h) under the sampler: how much
// too bright the printed estimator is. The factors of REPORT 3.9 and their closed form.
TEST(Statistical_ReportGgx, PrintedDensityIsTooBrightByTheseFactors) {
  constexpr std::array widths = {1.0, 0.5, 0.2, 0.1, 0.05};
  constexpr std::array factors = {1.000, 1.709, 3.994, 7.890, 15.727};
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const double a = widths[i];
    const double factor = unit_integral([&](double xi1) {
      const double theta = printed::ggx_theta(xi1, a);
      const double true_pdf =
          printed::ggx_distribution(std::cos(theta), a) * std::cos(theta) / 4;  // times 1 / (wo.h)
      return true_pdf / printed::ggx_pdf(theta, a, 1);
    });
    EXPECT_NEAR(factor, factors[i], 1e-3) << "a " << a;
    if (a == 1) continue;
    EXPECT_NEAR(factor, 0.5 + std::acos(a) / (2 * a * std::sqrt(1 - a * a)), 1e-3);
  }
}

}  // namespace
}  // namespace candela
