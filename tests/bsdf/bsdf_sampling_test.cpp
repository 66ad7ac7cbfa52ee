// Every BSDF with densities: its density integrates to the fraction that it accepts, its samples
// follow the density, and sample / evaluate / pdf say the same.
#include <gtest/gtest.h>

#include "renderer/bsdf/dispatch.h"
#include "tests/bsdf/bsdf_cases.h"
#include "tests/bsdf/test_sampler.h"
#include "tests/statistics/direction_sampling.h"
#include "tests/statistics/distributions.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using tests::BsdfCase;
using tests::direction_of;

constexpr int sample_count = 1'000'000;

// A grid that resolves the lobes: about the mirror direction where they are narrow.
statistics::DirectionGrid grid_for(const Bsdf& bsdf, const Vec3f& wo) {
  const bool has_narrow_lobe = bsdf.model != BsdfModel::Diffuse && bsdf.alpha < 0.15f;
  if (!has_narrow_lobe) return {};
  const bool is_dielectric =
      bsdf.model == BsdfModel::Dielectric || bsdf.model == BsdfModel::AnisotropicDielectric;
  if (!is_dielectric) return {.axis = normalize(Vec3f{-wo.x, -wo.y, wo.z}), .power = 3};
  const DielectricFresnel fresnel = fresnel_dielectric(wo.z, bsdf.eta.x);
  if (fresnel.cos_transmitted == 0)
    return {.axis = normalize(Vec3f{-wo.x, -wo.y, wo.z}), .power = 3};
  return {.axis = refract(wo, {0, 0, 1}, wo.z, fresnel.cos_transmitted, bsdf.eta.x), .power = 3};
}

struct SamplerCase {
  BsdfCase bsdf;
  float cos_theta_o;
};

std::vector<SamplerCase> sampler_cases() {
  std::vector<SamplerCase> cases;
  for (const BsdfCase& bsdf : tests::rough_cases())
    for (const float cos_theta_o : {0.97f, 0.4f, 0.06f}) cases.push_back({bsdf, cos_theta_o});
  return cases;
}

statistics::DirectionTestResult test_sampler(const Bsdf& bsdf, const Vec3f& wo,
                                             std::uint64_t seed) {
  return tests::test_sampler(bsdf, wo, grid_for(bsdf, wo), seed, sample_count);
}

TEST(Statistical_BsdfSampling, DirectionsFollowTheDensity) {
  const std::vector<SamplerCase> cases = sampler_cases();
  const double level = statistics::sidak_level(0.01, static_cast<double>(2 * cases.size()));
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE(cases[i].bsdf.name + " at cosine " + std::to_string(cases[i].cos_theta_o));
    const Vec3f wo = direction_of(cases[i].cos_theta_o, 0.7f);
    const auto result = test_sampler(cases[i].bsdf.bsdf, wo, 100 + i);
    EXPECT_GT(result.chi_square.p_value, level)
        << result.chi_square.statistic << " with " << result.chi_square.degrees_of_freedom
        << " degrees of freedom " << result.chi_square.message;
    EXPECT_LE(result.integral, 1 + 1e-4);
    // The fraction accepted is binomial about the integral.
    const double integral = std::min(1.0, result.integral);
    const double error = std::sqrt(std::max(1e-8, integral * (1 - integral) / sample_count));
    EXPECT_LT(std::abs(result.accepted_fraction - integral),
              error * statistics::normal_quantile(1 - level / 2));
  }
}

// A density that is 2 % too wide must be seen.
TEST(Statistical_BsdfSampling, WrongDensityFails) {
  const Bsdf right = tests::conductor(0.5f);
  Bsdf wrong = right;
  wrong.alpha *= 1.02f;
  const Vec3f wo = direction_of(0.4f, 0.7f);
  const auto result = statistics::test_directions(
      [&](float lobe, Vec2f direction) -> std::optional<Vec3f> {
        const BsdfSample sample = sample_bsdf(right, wo, lobe, direction);
        if (!(sample.pdf > 0)) return std::nullopt;
        return sample.wi;
      },
      [&](const Vec3f& wi) { return double{evaluate_bsdf(wrong, wo, wi).pdf}; }, {}, 1);
  EXPECT_LT(result.chi_square.p_value, 1e-6);
}

TEST(Unit_BsdfSampling, SampleAgreesWithEvaluate) {
  for (const BsdfCase& c : tests::rough_cases()) {
    SCOPED_TRACE(c.name);
    for (std::uint32_t i = 0; i < 4096; ++i) {
      const Vec2f u = owen_sobol_2d(i, 1);
      const Vec3f wo = direction_of(std::max(1e-4f, owen_sobol_1d(i, 2)), 1);
      const BsdfSample sample = sample_bsdf(c.bsdf, wo, owen_sobol_1d(i, 3), u);
      if (!(sample.pdf > 0)) {
        ASSERT_TRUE(is_black(sample.weight));
        continue;
      }
      const BsdfEvaluation evaluation = evaluate_bsdf(c.bsdf, wo, sample.wi);
      ASSERT_EQ(evaluation.pdf, sample.pdf);
      for (int channel = 0; channel < 3; ++channel)
        ASSERT_FLOAT_EQ(evaluation.value[channel] / evaluation.pdf, sample.weight[channel]);
      ASSERT_EQ(sample.eta, sample.wi.z < 0 ? c.bsdf.eta.x : 1.0f);
      ASSERT_FALSE(sample.is_delta);
    }
  }
}

// Full f over the full density: the mean weight is the albedo, which quadrature finds from
// evaluate() alone.
TEST(Statistical_BsdfSampling, MeanWeightIsTheAlbedo) {
  const std::vector<SamplerCase> cases = sampler_cases();
  const double level = statistics::sidak_level(0.01, static_cast<double>(cases.size()));
  for (const auto& [c, cos_theta_o] : cases) {
    SCOPED_TRACE(c.name + " at cosine " + std::to_string(cos_theta_o));
    const Bsdf& bsdf = c.bsdf;
    const Vec3f wo = direction_of(cos_theta_o, 0.7f);
    statistics::Moments weight;
    for (std::uint32_t i = 0; i < 60'000; ++i) {
      const std::uint64_t bits = mix_bits(i + 7);
      const float lobe = unit_float(static_cast<std::uint32_t>(mix_bits(bits)));
      weight.add(sample_bsdf(bsdf, wo, lobe,
                             {unit_float(static_cast<std::uint32_t>(bits)),
                              unit_float(static_cast<std::uint32_t>(bits >> 32))})
                     .weight.y);
    }
    const auto value = [&](const Vec3f& wi) { return evaluate_bsdf(bsdf, wo, wi).value.y; };
    const statistics::DirectionGrid grid = grid_for(bsdf, wo);
    const double albedo = statistics::integrate_sphere(value, grid);
    const double quadrature_error = statistics::integration_tolerance * grid.rings * grid.sectors;
    const double z =
        (weight.mean() - albedo) / std::hypot(weight.standard_error(), quadrature_error);
    EXPECT_GT(statistics::normal_two_sided(z), level) << weight.mean() << " against " << albedo;
  }
}

}  // namespace
}  // namespace candela
