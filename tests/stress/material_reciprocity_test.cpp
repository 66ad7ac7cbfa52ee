// Reciprocity to float error: f is the same with its directions exchanged, f / eta^2 across an
// interface [Veach97, eq. 5.14], for each roughness, index and angle.
#include <gtest/gtest.h>

#include "renderer/bsdf/dispatch.h"
#include "renderer/sampling/sobol.h"
#include "tests/bsdf/bsdf_cases.h"
#include "tests/stress/material_cases.h"
#include "tests/stress/row.h"

namespace candela {
namespace {

struct Worst {
  double reflection = 0;
  double refraction = 0;  // over refraction_tolerance()
};

double relative_difference(float a, float b) {
  return std::abs(double{a} - double{b}) / std::max(std::abs(double{a}), std::abs(double{b}));
}

Vec3f flipped(const Vec3f& w) {
  return {w.x, w.y, -w.z};
}

constexpr double reflection_tolerance = 1e-6;  // eight roundings

// The half vector of a refraction is a sum of directions divided by its length, |eta - 1| where
// they are opposite, so their rounding turns it by this angle: against the lobe's width, and
// against what is left to edge-on.
double refraction_tolerance(const Bsdf& bsdf, const Vec3f& wo, const Vec3f& wi) {
  const double eta = bsdf.eta.x;
  const double turn = 3e-7 * std::max(1.0, eta) / std::abs(eta - 1);
  const Vec3d h = normalize(Vec3d(wo) + eta * Vec3d(wi));
  const double cosine =
      std::min({std::abs(h.z), std::abs(dot(h, Vec3d(wo))), std::abs(dot(h, Vec3d(wi)))});
  const double width = std::min(bsdf.alpha, bsdf.alpha_across);  // the latter 1 where it is none
  return 3e-6 + turn / width + turn / cosine;
}

// Along a direction that the material sends light into.
void compare(const Bsdf& bsdf, const Vec3f& wo, const Vec3f& wi, Worst& worst) {
  const float there = evaluate_bsdf(bsdf, wo, wi).value.y / std::abs(wi.z);
  if (wi.z > 0) {
    const float back = evaluate_bsdf(bsdf, wi, wo).value.y / wo.z;
    worst.reflection = std::max(worst.reflection, relative_difference(there, back));
    return;
  }
  Bsdf other = bsdf;
  other.eta = Rgb{1 / bsdf.eta.x};
  const float back = evaluate_bsdf(other, flipped(wi), flipped(wo)).value.y / wo.z;
  const double difference = relative_difference(there * square(bsdf.eta.x), back);
  worst.refraction = std::max(worst.refraction, difference / refraction_tolerance(bsdf, wo, wi));
}

Worst worst_of(const Bsdf& bsdf) {
  constexpr float cosines[] = {1, 0.9f, 0.5f, 0.1f, 0.01f, 1e-3f, 1e-4f, 1e-6f};
  const std::uint32_t count = test::is_heavy() ? 1 << 18 : 1 << 13;
  Worst worst;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec3f wo = tests::direction_of(cosines[i % 8], 6.28f * owen_sobol_1d(i, 41));
    const BsdfSample sample = sample_bsdf(bsdf, wo, owen_sobol_1d(i, 42), owen_sobol_2d(i, 43));
    if (sample.pdf > 0 && !is_black(sample.weight)) compare(bsdf, wo, sample.wi, worst);
  }
  return worst;
}

TEST(Stress_MaterialReciprocity, HoldsToFloatError) {
  for (const float roughness : test::roughness_decades) {
    std::vector<test::MaterialCase> cases = test::all_material_cases(roughness);
    cases.push_back({fmt::format("compensated roughness {}", roughness),
                     tests::compensated(roughness, Rgb{0.2f}, Rgb{0.8f}, Rgb{0.6f})});
    Worst all;
    for (const test::MaterialCase& c : cases) {
      if (c.bsdf.is_smooth) continue;
      const Worst worst = worst_of(c.bsdf);
      EXPECT_LT(worst.reflection, reflection_tolerance) << c.name;
      EXPECT_LT(worst.refraction, 1) << c.name;
      all.reflection = std::max(all.reflection, worst.reflection);
      all.refraction = std::max(all.refraction, worst.refraction);
    }
    test::add_row(fmt::format("roughness {}", roughness),
                  {{"reflection_relative_difference", all.reflection},
                   {"refraction_difference_over_bound", all.refraction}});
  }
}

}  // namespace
}  // namespace candela
