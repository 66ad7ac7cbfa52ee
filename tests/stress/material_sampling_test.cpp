// The chi-square test of BSDF samplers where tests/bsdf does not go: lobes down to a hundredth of a
// degree, indices from 1.0001 to 1000 from both sides, grazing angles; and the choice between
// reflection and refraction, delta lobes too. At 1 %, corrected for the number of tests.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/bsdf/dispatch.h"
#include "renderer/sampling/hash.h"
#include "tests/bsdf/bsdf_cases.h"
#include "tests/bsdf/test_sampler.h"
#include "tests/statistics/direction_sampling.h"
#include "tests/statistics/distributions.h"
#include "tests/stress/material_cases.h"
#include "tests/stress/row.h"

namespace candela {
namespace {

using test::MaterialCase;

// What a lobe is about, and how wide it is there.
struct Lobe {
  Vec3f axis;
  double width = 1;
};

Vec3f mirrored(const Vec3f& wo) {
  return {-wo.x, -wo.y, wo.z};
}

Lobe lobe_of(const Bsdf& bsdf, const Vec3f& wo) {
  const Lobe reflection{mirrored(wo), 2 * double{bsdf.alpha}};
  if (bsdf.model != BsdfModel::Dielectric) return reflection;
  const DielectricFresnel fresnel = fresnel_dielectric(wo.z, bsdf.eta.x);
  if (fresnel.reflectance > 0.5f) return reflection;
  const double eta = bsdf.eta.x;
  // Nearly straight on: there, where no half vector is, the density has its finest structure.
  if (std::abs(eta - 1) < 0.01) return {-wo, double{bsdf.alpha} * std::abs(eta - 1)};
  return {refract(wo, {0, 0, 1}, wo.z, fresnel.cos_transmitted, bsdf.eta.x),
          double{bsdf.alpha} * std::abs(eta - 1) / eta};
}

// Half of the rings within the lobe.
statistics::DirectionGrid grid_for(const Bsdf& bsdf, const Vec3f& wo) {
  const Lobe lobe = lobe_of(bsdf, wo);
  return {.axis = lobe.axis,
          .power = std::max(1.0, std::log(lobe.width / pi_double) / std::log(0.5))};
}

std::vector<MaterialCase> narrow_and_odd_cases() {
  std::vector<MaterialCase> cases;
  for (const float roughness : {1.0f, 0.1f, 0.01f, 1e-3f}) {
    for (MaterialCase& c : test::dielectric_cases(roughness)) {
      if (c.bsdf.is_smooth) continue;
      // Two lobes apart, both too narrow for one grid: the reflection alone.
      if (c.bsdf.eta.x > 100 && roughness < 0.1f) c.bsdf.transmittance = Rgb{0};
      cases.push_back(std::move(c));
    }
    for (auto* more : {&test::layered_cases, &test::coated_cases})
      for (MaterialCase& c : more(roughness)) cases.push_back(std::move(c));
    cases.push_back(
        {fmt::format("conductor roughness {}", roughness), tests::conductor(roughness)});
    cases.push_back({fmt::format("compensated roughness {}", roughness),
                     tests::compensated(roughness, Rgb{0.2f}, Rgb{0.8f}, Rgb{0.6f})});
  }
  return cases;
}

// Half vectors are rounded by 1e-7 / |eta - 1| of the lobe's width, and densities with them; and
// cosines of angles about a critical angle of a thousandth by a tenth of it. More samples would see
// that.
int sample_count(const Bsdf& bsdf) {
  const bool is_coarse = bsdf.model == BsdfModel::Dielectric &&
                         (std::abs(bsdf.eta.x - 1) < 0.01f || bsdf.eta.x < 0.01f);
  return test::is_heavy() && !is_coarse ? 1'000'000 : 30'000;
}

statistics::DirectionTestResult test_sampler(const Bsdf& bsdf, const Vec3f& wo,
                                             std::uint64_t seed) {
  return tests::test_sampler(bsdf, wo, grid_for(bsdf, wo), seed, sample_count(bsdf));
}

// The densities' integrals over narrow cells take the time: the default suite does one in 23.
TEST(Stress_MaterialSampling, DirectionsFollowTheDensity) {
  const std::vector<MaterialCase> all = narrow_and_odd_cases();
  constexpr float cosines[] = {1, 0.5f, 0.03f};
  const std::size_t step = test::is_heavy() ? 1 : 23;
  const std::size_t count = 3 * all.size() / step;
  const double level = statistics::sidak_level(0.01, static_cast<double>(count));
  double least = 1;
  for (std::size_t i = 0; i < 3 * all.size(); i += step) {
    const MaterialCase& c = all[i / 3];
    const Vec3f wo = tests::direction_of(cosines[i % 3], 0.7f);
    const auto result = test_sampler(c.bsdf, wo, 500 + i);
    EXPECT_GT(result.chi_square.p_value, level)
        << c.name << " at cosine " << wo.z << ": " << result.chi_square.statistic << " with "
        << result.chi_square.degrees_of_freedom << " degrees of freedom, accepted "
        << result.accepted_fraction << " of " << result.integral << ' '
        << result.chi_square.message;
    least = std::min(least, result.chi_square.p_value);
  }
  test::add_row("all",
                {{"tests", static_cast<double>(count)}, {"least p", least}, {"each needs", level}});
}

// Of k successes in n trials, exactly.
double binomial_two_sided(double k, double n, double probability) {
  if (!(probability > 0) || !(probability < 1)) return k == n * probability ? 1 : 0;
  const double at_least = k > 0 ? statistics::incomplete_beta(k, n - k + 1, probability) : 1;
  const double at_most = k < n ? 1 - statistics::incomplete_beta(k + 1, n - k, probability) : 1;
  return std::min(1.0, 2 * std::min(at_least, at_most));
}

// How often a lobe is picked, against what its weight says was picked.
TEST(Stress_MaterialSampling, LobesArePickedAsOftenAsTheirWeightsSay) {
  std::vector<MaterialCase> cases = test::dielectric_cases(0);
  for (const float ior : test::refractive_indices)
    cases.push_back(
        {fmt::format("pane {}", ior), {.model = BsdfModel::ThinDielectric, .eta = Rgb{ior}}});
  const double tests_in_all = 4 * static_cast<double>(cases.size());
  const double level = statistics::sidak_level(0.01, tests_in_all);
  const int count = test::is_heavy() ? 2'000'000 : 300'000;
  for (const MaterialCase& c : cases)
    for (const float cos_o : {1.0f, 0.5f, 0.03f, 1e-4f}) {
      const Vec3f wo = tests::direction_of(cos_o, 0.7f);
      double reflected = 0;
      for (int i = 0; i < count; ++i) {
        const std::uint64_t bits = mix_bits(static_cast<std::uint64_t>(i) + 99);
        const float lobe = unit_float(static_cast<std::uint32_t>(bits >> 32));
        reflected += sample_bsdf(c.bsdf, wo, lobe, {}).wi.z < 0 ? 0 : 1;
      }
      // Without a tint the pick is by Fresnel's term itself, and of a pane by all its reflections.
      const double f = double{fresnel_dielectric(cos_o, c.bsdf.eta.x).reflectance};
      const double expected = c.bsdf.model == BsdfModel::Dielectric ? f : 2 * f / (1 + f);
      const double p = binomial_two_sided(reflected, count, expected);
      EXPECT_GT(p, level) << c.name << " at cosine " << cos_o << ": " << reflected / count
                          << ", expected " << expected;
    }
}

}  // namespace
}  // namespace candela
