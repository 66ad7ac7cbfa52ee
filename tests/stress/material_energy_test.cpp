// Of each material at the ends of its parameters, the light that its samples carry away: within
// 1e-3 of what the papers' formulas give in double, from straight above to grazing.
#include <gtest/gtest.h>

#include "renderer/bsdf/dispatch.h"
#include "renderer/sampling/sobol.h"
#include "tests/bsdf/bsdf_cases.h"
#include "tests/bsdf/reference_bsdf.h"
#include "tests/statistics/moments.h"
#include "tests/stress/material_cases.h"
#include "tests/stress/row.h"

namespace candela {
namespace {

using test::MaterialCase;

constexpr double tolerance = 1e-3;

// Weights without radiance's 1 / eta^2, until their mean is known to a quarter of the tolerance.
statistics::Moments sampled_energy(const Bsdf& bsdf, const Vec3f& wo) {
  const std::uint32_t most = test::is_heavy() ? 1 << 22 : 1 << 16;
  constexpr std::uint32_t least = 1 << 13;  // what is rare must have been met
  statistics::Moments energy;
  for (std::uint32_t i = 0; i < most; ++i) {
    const BsdfSample sample = sample_bsdf(bsdf, wo, owen_sobol_1d(i, 31), owen_sobol_2d(i, 32));
    energy.add(double{sample.weight.y} * square(double{sample.eta}));
    const bool is_net = (energy.count() & i) == 0;  // a power of two of them
    if (is_net && energy.count() >= least && energy.standard_error() < tolerance / 4) break;
  }
  return energy;
}

std::vector<float> cosines() {
  if (!test::is_heavy()) return {1, 0.3f, 1e-3f, 1e-6f};
  return {1, 0.9f, 0.7f, 0.5f, 0.3f, 0.1f, 0.03f, 0.01f, 1e-3f, 1e-4f, 1e-5f, 1e-6f, 1e-7f};
}

// The few samples of the default suite may need more than the tolerance; the heavy ones may not.
double allowed(const statistics::Moments& found) {
  return test::is_heavy() ? tolerance : std::max(tolerance, 4.5 * found.standard_error());
}

double reference_albedo(const Bsdf& bsdf, const Vec3f& wo) {
  return tests::reference_albedo(bsdf, normalize(Vec3d(wo)), test::is_heavy() ? 256 : 128);
}

void expect_energy(const std::string& name, const std::vector<MaterialCase>& cases,
                   double (*expected_of)(const Bsdf&, const Vec3f& wo) = reference_albedo) {
  double worst = 0;
  for (const MaterialCase& c : cases)
    for (const float cos_o : cosines()) {
      const Vec3f wo = tests::direction_of(cos_o, 0.3f);
      const double expected = expected_of(c.bsdf, wo);
      const statistics::Moments found = sampled_energy(c.bsdf, wo);
      EXPECT_NEAR(found.mean(), expected, allowed(found)) << c.name << " at cosine " << cos_o;
      worst = std::max(worst, std::abs(found.mean() - expected));
    }
  test::add_row(name, {{"cases", static_cast<double>(cases.size() * cosines().size())},
                       {"worst_deviation", worst}});
}

std::vector<MaterialCase> of_all_decades(std::vector<MaterialCase> (*cases_of)(float)) {
  std::vector<MaterialCase> all;
  for (const float roughness : test::roughness_decades)
    for (MaterialCase& c : cases_of(roughness)) all.push_back(std::move(c));
  return all;
}

TEST(Stress_MaterialEnergy, Conductors) {
  expect_energy("conductors", of_all_decades(test::conductor_cases));
}
TEST(Stress_MaterialEnergy, Dielectrics) {
  expect_energy("dielectrics", of_all_decades(test::dielectric_cases));
}
TEST(Stress_MaterialEnergy, DiffuseUnderSpecular) {
  expect_energy("diffuse under specular", of_all_decades(test::layered_cases));
}
TEST(Stress_MaterialEnergy, Brushed) {
  expect_energy("brushed", of_all_decades(test::anisotropic_cases));
}
std::vector<MaterialCase> coated_cases(BsdfModel model) {
  std::vector<MaterialCase> cases = of_all_decades(test::coated_cases);
  std::erase_if(cases,
                [&](const auto& c) { return c.bsdf.model != model || is_only_delta(c.bsdf); });
  return cases;
}
// Of the coat alone.
double coat_albedo(const Bsdf& bsdf, const Vec3f& wo) {
  return reference_albedo({.model = BsdfModel::AnisotropicDielectric,
                           .is_smooth = bsdf.alpha == 0,
                           .alpha = bsdf.alpha,
                           .eta = Rgb{bsdf.coat->eta()},
                           .transmittance = Rgb{0},
                           .alpha_across = bsdf.alpha_across},
                          wo);
}
// What comes from below is what random walks bring (tests/bsdf/coated_*_test.cpp), kept in tables.
TEST(Stress_MaterialEnergy, CoatedDiffuse) {
  expect_energy("coated diffuse", coated_cases(BsdfModel::CoatedDiffuse),
                [](const Bsdf& bsdf, const Vec3f& wo) {
                  return coat_albedo(bsdf, wo) + double{coated_diffuse_albedo(bsdf, wo.z).y};
                });
}
TEST(Stress_MaterialEnergy, CoatedMetal) {
  expect_energy("coated metal", coated_cases(BsdfModel::CoatedConductor),
                [](const Bsdf& bsdf, const Vec3f& wo) {
                  return coat_albedo(bsdf, wo) + double{bsdf.metal->albedo(wo.z).y};
                });
}
TEST(Stress_MaterialEnergy, PanesAndMirrors) {
  std::vector<MaterialCase> cases;
  for (const float ior : test::refractive_indices)
    for (const float tint : {1.0f, 0.7f, 0.0f})
      cases.push_back(
          {fmt::format("pane {} tint {}", ior, tint),
           {.model = BsdfModel::ThinDielectric, .eta = Rgb{ior}, .transmittance = Rgb{tint}}});
  cases.push_back({"mirror", {.model = BsdfModel::Mirror, .diffuse = Rgb{0.6f}}});
  cases.push_back({"diffuse", {.model = BsdfModel::Diffuse, .diffuse = Rgb{0.6f}}});
  expect_energy("panes, mirror, diffuse", cases);
}

// One bounce by its formula and the others by the table: white is white.
TEST(Stress_MaterialEnergy, CompensatedWhite) {
  const bool is_heavy = test::is_heavy();
  const std::vector<float> widths =
      is_heavy ? std::vector<float>{1e-4f,  3e-4f, 1e-3f, 3e-3f, 0.01f, 0.02f, 0.03f,
                                    0.045f, 0.07f, 0.1f,  0.15f, 0.2f,  0.3f,  0.42f,
                                    0.5f,   0.6f,  0.71f, 0.8f,  0.9f,  0.96f, 1}
               : std::vector<float>{1e-3f, 0.01f, 0.15f, 0.42f, 1};
  double lowest = 2, highest = 0;
  for (const float a : widths)
    for (const float cos_o : cosines()) {
      const Vec3f wo = tests::direction_of(cos_o, 0.3f);
      const Bsdf one_bounce = tests::cook_torrance(a, Rgb{0}, Rgb{1}, Rgb{1}, GeometryTerm::Smith);
      const Bsdf all = tests::compensated(a, Rgb{0}, Rgb{1}, Rgb{1});
      const double found = tests::reference_albedo(one_bounce, normalize(Vec3d(wo))) +
                           double{multiple_albedo(all, cos_o).y};
      EXPECT_NEAR(found, 1, tolerance) << "width " << a << " at cosine " << cos_o;
      lowest = std::min(lowest, found);
      highest = std::max(highest, found);
    }
  test::add_row("white", {{"least albedo", lowest}, {"largest albedo", highest}});
}

}  // namespace
}  // namespace candela
