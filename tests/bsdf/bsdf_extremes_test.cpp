// No NaN, no infinity, nothing negative: at the ends of all parameters and at grazing angles.
#include <gtest/gtest.h>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include <limits>

#include "renderer/bsdf/dispatch.h"
#include "tests/bsdf/bsdf_cases.h"

namespace candela {
namespace {

using tests::direction_of;

bool is_valid(const Rgb& c) {
  return is_finite(c) && min_component(c) >= 0;
}

// Models at the ends of their parameters.
std::vector<Bsdf> extreme_bsdfs() {
  std::vector<Bsdf> all;
  for (const float a : {0.0f, 1e-20f, 1e-6f, 1e-4f, 1e-3f, 0.3f, 1.0f}) {
    for (const GeometryTerm geometry : {GeometryTerm::SchlickGgx, GeometryTerm::Smith})
      for (const FresnelTerm fresnel :
           {FresnelTerm::Schlick, FresnelTerm::Dielectric, FresnelTerm::Conductor}) {
        Bsdf bsdf = tests::cook_torrance(a, Rgb{0.5f, 0, 0}, Rgb{0.5f, 1, 0}, Rgb{0}, geometry);
        bsdf.fresnel = fresnel;
        all.push_back(bsdf);
      }
    for (const float ks : {0.0f, 1e-30f, 1.0f}) all.push_back(tests::lab(a, Rgb{ks}, Rgb{ks}));
    for (const float eta : {1.0f, 1.0000001f, 1.5f, 1000.0f, 0.001f}) {
      for (const float k : {0.0f, 100.0f}) {
        Bsdf bsdf = tests::conductor(a);
        bsdf.eta = Rgb{eta};
        bsdf.k = Rgb{k};
        all.push_back(bsdf);
      }
      all.push_back(tests::dielectric(a, eta));
      all.push_back(tests::dielectric(a, eta, Rgb{0}));
      all.push_back({.model = BsdfModel::ThinDielectric, .eta = Rgb{eta}});
    }
  }
  for (const float along : {1e-4f, 1e-2f, 1.0f})
    for (const float across : {1e-4f, 0.3f}) {
      all.push_back(tests::anisotropic_conductor(along, across));
      all.push_back(tests::anisotropic_dielectric(along, across, 1.5f));
      all.push_back(tests::anisotropic_dielectric(along, across, 0.6f));
      all.push_back(tests::coated_diffuse(along, across, Rgb{1}));
    }
  all.push_back(tests::coated_diffuse(0, 0, Rgb{1}));
  for (const float coat : {0.0f, 1e-3f, 1.0f})
    for (const float metal : {0.0f, 1e-3f, 1.0f})
      all.push_back(tests::coated_conductor(coat, metal));
  all.push_back(tests::sheet(Rgb{0}, Rgb{1}));
  all.push_back(tests::sheet(Rgb{0}, Rgb{0}));
  all.push_back({.model = BsdfModel::Mirror, .diffuse = Rgb{1}});
  all.push_back({.model = BsdfModel::Diffuse, .diffuse = Rgb{0}});
  return all;
}

std::vector<Vec3f> extreme_directions() {
  std::vector<Vec3f> all;
  const float tiny = std::numeric_limits<float>::min();
  for (const float z : {1.0f, 0.9999999f, 0.5f, 1e-3f, 1e-7f, 1e-20f, tiny, tiny / 8})
    for (const float phi : {0.0f, 1.0f, 3.14159274f}) {
      const Vec3f direction = direction_of(z, phi);
      if (direction.z > 0) all.push_back(direction);  // not where denormal numbers are 0
    }
  return all;
}

void expect_valid_samples() {
  for (const Bsdf& bsdf : extreme_bsdfs())
    for (const Vec3f& wo : extreme_directions())
      for (const float u : {0.0f, 0.3f, one_minus_epsilon})
        for (const float v : {0.0f, 1e-7f, 0.6f, one_minus_epsilon})
          for (const float lobe : {0.0f, 0.5f, one_minus_epsilon}) {
            const BsdfSample sample = sample_bsdf(bsdf, wo, lobe, {u, v});
            ASSERT_TRUE(is_valid(sample.weight) && sample.pdf >= 0 && sample.pdf < infinity)
                << static_cast<int>(bsdf.model) << " a " << bsdf.alpha << " eta " << bsdf.eta.x
                << " wo.z " << wo.z << " weight " << sample.weight.x << " pdf " << sample.pdf;
            if (is_black(sample.weight)) continue;
            ASSERT_NEAR(length_squared(sample.wi), 1, 1e-5)
                << static_cast<int>(bsdf.model) << " a " << bsdf.alpha << " eta " << bsdf.eta.x
                << " wo.z " << wo.z;
            ASSERT_NE(sample.wi.z, 0);
          }
}

void expect_valid_evaluations() {
  const std::vector<Vec3f> directions = extreme_directions();
  for (const Bsdf& bsdf : extreme_bsdfs())
    for (const Vec3f& wo : directions) {
      for (const Vec3f& wi : directions)
        for (const float side : {1.0f, -1.0f}) {
          const BsdfEvaluation e = evaluate_bsdf(bsdf, wo, {wi.x, wi.y, side * wi.z});
          ASSERT_TRUE(is_valid(e.value) && e.pdf >= 0 && e.pdf < infinity)
              << static_cast<int>(bsdf.model) << " a " << bsdf.alpha << " eta " << bsdf.eta.x
              << " wo.z " << wo.z << " wi.z " << wi.z;
        }
      ASSERT_EQ(evaluate_bsdf(bsdf, wo, {1, 0, 0}).pdf, 0);
      const Rgb albedo = albedo_estimate(bsdf, wo);
      ASSERT_TRUE(is_valid(albedo) && max_component(albedo) <= 1);
    }
}

TEST(Unit_BsdfExtremes, SamplesAreNeverInvalid) {
  expect_valid_samples();
}
TEST(Unit_BsdfExtremes, EvaluationsAreNeverInvalid) {
  expect_valid_evaluations();
}

#if defined(__SSE2__)
// As the rendering threads run: denormal numbers are zero, both read (DAZ) and written (FTZ).
TEST(Unit_BsdfExtremes, NeverInvalidWithoutDenormals) {
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040u);
  expect_valid_samples();
  expect_valid_evaluations();
  _mm_setcsr(before);
}
#endif

}  // namespace
}  // namespace candela
