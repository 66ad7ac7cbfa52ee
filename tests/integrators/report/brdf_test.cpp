// REPORT 2.3 and 3.6: where the Fresnel term and the geometry term are evaluated.
#include <gtest/gtest.h>

#include <array>

#include "renderer/bsdf/dispatch.h"
#include "tests/bsdf/bsdf_cases.h"
#include "tests/integrators/report/printed_formulas.h"
#include "tests/statistics/direction_sampling.h"

namespace candela {
namespace {

using tests::direction_of;

constexpr float alpha = 0.3f;
constexpr float r0 = 0.04f;

Bsdf corrected(float f0) {
  return tests::cook_torrance(alpha, Rgb{0}, Rgb{1}, Rgb{f0}, GeometryTerm::SchlickGgx);
}

// f_s of the printed formulas, but for what F is evaluated at.
double printed_f(const Vec3f& wo, const Vec3f& wi) {
  const Vec3d h = normalize(Vec3d(wo) + Vec3d(wi));
  const double f = printed::fresnel(r0, wi.z);
  const double g = printed::g1(wi.z, alpha) * printed::g1(wo.z, alpha);
  return printed::specular(f, g, printed::ggx_distribution(h.z, alpha), wi.z, wo.z);
}

double corrected_f(const Vec3f& wo, const Vec3f& wi) {
  return evaluate_bsdf(corrected(r0), wo, wi).value.y / wi.z;
}

// F(wi, N) lets light that goes one way meet another surface than light that comes back.
TEST(Statistical_ReportBrdf, FresnelAtTheNormalBreaksReciprocity) {
  const Vec3f steep = direction_of(0.95f, 0);
  const Vec3f grazing = direction_of(0.1f, 2.5f);
  EXPECT_GT(printed_f(steep, grazing) / printed_f(grazing, steep), 10);
  EXPECT_NEAR(corrected_f(steep, grazing) / corrected_f(grazing, steep), 1, 1e-5);
}

// In the mirror direction h = n, and both are the same.
TEST(Statistical_ReportBrdf, FresnelAtTheNormalIsRightForMirrorDirections) {
  const Vec3f wo = direction_of(0.4f, 0);
  const Vec3f wi = direction_of(0.4f, pi);
  EXPECT_NEAR(printed_f(wo, wi) / corrected_f(wo, wi), 1, 1e-4);
}

// The share of the light from wo that a surface of reflectance 1 sends back, with G1 of (w.h).
double printed_albedo(const Vec3f& wo) {
  const auto f_cosine = [&](const Vec3f& wi) {
    if (!(wi.z > 0)) return 0.0;
    const Vec3d h = normalize(Vec3d(wo) + Vec3d(wi));
    const double g1 = printed::g1(dot(Vec3d(wo), h), alpha);
    return printed::specular(1, g1 * g1, printed::ggx_distribution(h.z, alpha), wi.z, wo.z) * wi.z;
  };
  return statistics::integrate_sphere(f_cosine, {});
}

double corrected_albedo(const Vec3f& wo) {
  const auto value = [&](const Vec3f& wi) { return evaluate_bsdf(corrected(1), wo, wi).value.y; };
  return statistics::integrate_sphere(value, {});
}

// G1(w.h) does not vanish at grazing angles, where f cos goes like 1 / (n.wo): more light leaves
// than came. With n.w it is dark there (k >= 1/8) but never gains.
TEST(Statistical_ReportBrdf, GeometryOfTheHalfVectorBreaksEnergyConservation) {
  for (const float cos_o : {0.05f, 0.02f}) {
    EXPECT_GT(printed_albedo(direction_of(cos_o, 0)), 1.1) << cos_o;
    EXPECT_LT(corrected_albedo(direction_of(cos_o, 0)), 1) << cos_o;
  }
  EXPECT_GT(printed_albedo(direction_of(0.02f, 0)), printed_albedo(direction_of(0.05f, 0)));
}

}  // namespace
}  // namespace candela
