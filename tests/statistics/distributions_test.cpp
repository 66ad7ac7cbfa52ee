#include "tests/statistics/distributions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace candela::statistics {
namespace {

void expect_relative(double value, double expected, double relative) {
  EXPECT_NEAR(value, expected, std::abs(expected) * relative) << "expected " << expected;
}

// P(n, x) for whole n is 1 minus a sum of Poisson probabilities.
TEST(Unit_Distributions, GammaAgreesWithPoissonSums) {
  for (const int n : {1, 2, 5, 30}) {
    for (const double x : {0.1, 1.0, 4.9, 30.0, 60.0}) {
      double term = std::exp(-x);
      double sum = 0;
      for (int k = 0; k < n; ++k) {
        sum += term;
        term *= x / (k + 1);
      }
      expect_relative(gamma_q(n, x), sum, 1e-11);
      EXPECT_NEAR(gamma_p(n, x) + gamma_q(n, x), 1, 1e-14);
    }
  }
}

// A chi-square variable with one degree of freedom is a squared normal one.
TEST(Unit_Distributions, ChiSquareAgreesWithNormal) {
  for (const double z : {0.1, 1.0, 3.0, 8.0, 20.0})
    expect_relative(chi_square_survival(z * z, 1), normal_two_sided(z), 1e-10);
  expect_relative(chi_square_survival(2 * 7.5, 2), std::exp(-7.5), 1e-12);
}

TEST(Unit_Distributions, ManyDegreesOfFreedomConverge) {
  // Wilson and Hilferty's cube-root approximation is good to about 1e-3 here.
  const double k = 1e5;
  const double x = k + 3 * std::sqrt(2 * k);
  const double z = (std::cbrt(x / k) - (1 - 2 / (9 * k))) / std::sqrt(2 / (9 * k));
  expect_relative(chi_square_survival(x, k), normal_survival(z), 1e-3);
}

// Closed forms for 1, 2 and 4 degrees of freedom.
TEST(Unit_Distributions, StudentAgreesWithClosedForms) {
  for (const double t : {-30.0, -2.0, -0.3, 0.5, 1.0, 4.0, 100.0}) {
    EXPECT_NEAR(t_cdf(t, 1), 0.5 + std::atan(t) / M_PI, 1e-13);
    EXPECT_NEAR(t_cdf(t, 2), 0.5 + t / (2 * std::sqrt(2 + t * t)), 1e-13);
    const double u = t / std::sqrt(1 + t * t / 4);
    EXPECT_NEAR(t_cdf(t, 4), 0.5 + 0.375 * u * (1 - u * u / 12), 1e-13);
  }
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(t_cdf(1.7, infinite), normal_cdf(1.7), 1e-15);
  expect_relative(t_two_sided(3, 1e6), normal_two_sided(3), 1e-4);
}

TEST(Unit_Distributions, QuantilesInvert) {
  for (const double p : {1e-12, 1e-4, 0.3, 0.5, 0.975, 0.9999}) {
    EXPECT_NEAR(normal_cdf(normal_quantile(p)), p, 1e-14);
    EXPECT_NEAR(t_cdf(t_quantile(p, 3), 3), p, 1e-14);
  }
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-12);
  EXPECT_NEAR(t_quantile(0.975, 10), 2.228138851964939, 1e-10);
}

TEST(Unit_Distributions, KolmogorovKnowsItsTable) {
  EXPECT_NEAR(kolmogorov_survival(1.3581 / std::sqrt(1e6), 1e6), 0.05, 1e-4);
  EXPECT_NEAR(kolmogorov_survival(1.6276 / std::sqrt(1e6), 1e6), 0.01, 1e-4);
}

TEST(Unit_Distributions, SidakCorrects) {
  EXPECT_NEAR(std::pow(1 - sidak_level(0.01, 50), 50), 0.99, 1e-14);
  expect_relative(sidak_p_value(sidak_level(0.01, 4096), 4096), 0.01, 1e-12);
  expect_relative(sidak_p_value(1e-30, 100), 1e-28, 1e-12);
}

}  // namespace
}  // namespace candela::statistics
