// REPORT 3.8: the directions of diffuse surfaces and their density.
#include <gtest/gtest.h>

#include <array>

#include "renderer/math/constants.h"
#include "renderer/sampling/warp.h"
#include "tests/integrators/report/printed_formulas.h"
#include "tests/integrators/report/quadrature.h"
#include "tests/statistics/direction_sampling.h"

namespace candela {
namespace {

using statistics::test_directions;

using tests::unit_integral;

// theta = arccos sqrt(1 - xi1), the inversion of the marginal 2 sin cos.
double corrected_theta(double xi1) {
  return std::acos(std::sqrt(1 - xi1));
}

double cosine_over_pi(const Vec3f& w) {
  return std::max(0.0, double{w.z}) / pi_double;
}

Vec3f polar(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

template <class Theta>
statistics::DirectionSampler by_polar_angle(Theta theta) {
  return [theta](float, Vec2f xi) { return polar(theta(xi.x), 2 * pi_double * xi.y); };
}

// The printed angle makes cos(theta) uniform: a uniform hemisphere, not a cosine-weighted one.
TEST(Statistical_ReportCosine, PrintedAngleIsTheUniformHemisphere) {
  const auto sampler = by_polar_angle(printed::cosine_theta);
  const auto uniform = [](const Vec3f& w) { return w.z > 0 ? 0.5 / pi_double : 0.0; };
  EXPECT_LT(test_directions(sampler, cosine_over_pi, {}, 1).chi_square.p_value, 1e-30);
  EXPECT_GT(test_directions(sampler, uniform, {}, 1).chi_square.p_value, 0.01);
}

TEST(Statistical_ReportCosine, CorrectedAngleFollowsCosineOverPi) {
  const auto polar_form = test_directions(by_polar_angle(corrected_theta), cosine_over_pi, {}, 2);
  const auto warp =
      test_directions([](float, Vec2f xi) { return square_to_cosine_hemisphere(xi); },
                      [](const Vec3f& w) { return double{cosine_hemisphere_pdf(w.z)}; }, {}, 3);
  EXPECT_GT(polar_form.chi_square.p_value, 0.01);
  EXPECT_GT(warp.chi_square.p_value, 0.01);
  EXPECT_NEAR(warp.integral, 1, 1e-4);
}

// cos sin / pi is a density over (theta, phi). Over solid angle, the measure of the integral that
// step 4 estimates, it integrates to 2/3: not a density at all.
TEST(Statistical_ReportCosine, PrintedDensityIsNotOneOfSolidAngle) {
  const auto printed_density = [](const Vec3f& w) {
    return w.z > 0 ? printed::cosine_pdf(std::acos(double{w.z})) : 0.0;
  };
  EXPECT_NEAR(statistics::integrate_sphere(printed_density, {}), 2.0 / 3, 1e-4);
  EXPECT_NEAR(statistics::integrate_sphere(cosine_over_pi, {}), 1, 1e-4);
}

// What the estimator L f cos / pdf of a white Lambert surface gives on average, f = 1 / pi.
template <class Theta, class Pdf, class Radiance>
double mean_estimate(Theta theta, Pdf pdf, Radiance radiance) {
  return unit_integral([&](double xi1) {
    const double angle = theta(xi1);
    return radiance(angle) * std::cos(angle) / pi_double / pdf(angle);
  });
}

// The table of REPORT 3.8, row by row, as it is printed there: L = 1 has the answer 1, L = cos the
// answer 2/3. Only the last row has both; L = 1 alone would let the second row pass.
TEST(Statistical_ReportCosine, FurnacesSeparateTheFourCombinations) {
  const auto one = [](double) { return 1.0; };
  const auto cosine = [](double angle) { return std::cos(angle); };
  const auto corrected_pdf = [](double angle) { return std::cos(angle) / pi_double; };
  const auto expect_row = [&](auto theta, auto pdf, double constant_sky, double cosine_sky) {
    EXPECT_NEAR(mean_estimate(theta, pdf, one), constant_sky, 5e-4);
    EXPECT_NEAR(mean_estimate(theta, pdf, cosine), cosine_sky, 5e-4);
  };
  expect_row(printed::cosine_theta, printed::cosine_pdf, 1.571, 1.000);
  expect_row(printed::cosine_theta, corrected_pdf, 1.000, 0.500);
  expect_row(corrected_theta, printed::cosine_pdf, 2.000, 1.571);
  expect_row(corrected_theta, corrected_pdf, 1.000, 0.667);
}

}  // namespace
}  // namespace candela
