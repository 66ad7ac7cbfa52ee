#include "renderer/medium/phase_function.h"

#include <gtest/gtest.h>

#include "tests/statistics/direction_sampling.h"
#include "tests/statistics/distributions.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

constexpr float asymmetries[] = {-0.95f, -0.5f, -1e-4f, 0, 1e-4f, 0.3f, 0.8f, 0.99f};

// Light that comes along -wo goes on along the axis.
const Vec3f wo = -normalize(Vec3f{0.3f, -0.5f, 0.7f});

statistics::DirectionGrid grid_about_peak(float g) {
  return {.axis = g < 0 ? wo : -wo, .power = std::abs(g) > 0.9f ? 3.0 : 1.0};
}

TEST(Statistical_PhaseFunction, DirectionsFollowTheDensity) {
  const double level = statistics::sidak_level(0.01, std::size(asymmetries));
  for (std::size_t i = 0; i < std::size(asymmetries); ++i) {
    const float g = asymmetries[i];
    SCOPED_TRACE(g);
    const auto result = statistics::test_directions(
        [&](float, Vec2f u) -> std::optional<Vec3f> { return sample_phase_function(g, wo, u).wi; },
        [&](const Vec3f& wi) { return double{phase_function(g, wo, wi)}; }, grid_about_peak(g),
        40 + i, 200'000);
    EXPECT_GT(result.chi_square.p_value, level) << result.chi_square.message;
    EXPECT_NEAR(result.integral, 1, 1e-4);
  }
}

// By the midpoint rule, whose error for so smooth a function is far below the bound.
TEST(Unit_PhaseFunction, MeanCosineIsTheAsymmetry) {
  constexpr int steps = 1 << 16;
  for (const float g : asymmetries) {
    double sum = 0;
    double mean = 0;
    for (int i = 0; i < steps; ++i) {
      const double cosine = sampled_phase_cosine(double{g}, (i + 0.5) / steps);
      mean += cosine / steps;
      sum += 1.0 / steps;
    }
    EXPECT_NEAR(mean / sum, double{g}, 2e-5) << g;
  }
}

// The textbook's forms of the cosine and of the density [Pharr23, eq. 11.3.1 and 11.3.2].
TEST(Unit_PhaseFunction, IsTheTextbooks) {
  for (const double g : {-0.7, 0.4, 0.9})
    for (const double u : {0.01, 0.3, 0.5, 0.99}) {
      const double square_term = (1 - square(g)) / (1 - g + 2 * g * u);
      const double cosine = (1 + square(g) - square(square_term)) / (2 * g);
      EXPECT_NEAR(sampled_phase_cosine(g, u), cosine, 1e-12);
      const double density =
          (1 - square(g)) / (4 * 3.14159265358979) / std::pow(1 + square(g) - 2 * g * cosine, 1.5);
      const auto sine = static_cast<float>(std::sqrt(1 - cosine * cosine));
      const Vec3f wi{sine, 0, static_cast<float>(cosine)};
      EXPECT_NEAR(phase_function(static_cast<float>(g), {0, 0, -1}, wi), density, 2e-6 * density);
    }
}

// Where the peak is narrow, a sampled direction has the density that its cosine says.
TEST(Unit_PhaseFunction, NarrowPeaksKeepTheirDensity) {
  const float g = 0.9999f;
  statistics::Moments ratio;
  for (int i = 0; i < 1000; ++i) {
    const float u = (static_cast<float>(i) + 0.5f) / 1000;
    const PhaseSample sample = sample_phase_function(g, wo, {u, 0.37f});
    const double cosine = sampled_phase_cosine(double{g}, double{u});
    const double gd{g};
    const double density = (1 - gd * gd) / (4 * 3.14159265358979) /
                           std::pow(square(1 - gd) + 2 * gd * (1 - cosine), 1.5);
    ratio.add(double{sample.pdf} / density);
  }
  EXPECT_NEAR(ratio.mean(), 1, 1e-2);
}

}  // namespace
}  // namespace candela
