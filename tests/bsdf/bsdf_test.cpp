// What the models are: their formulas written again plainly in double, reciprocity, dispatch.
#include <gtest/gtest.h>

#include "renderer/bsdf/dispatch.h"
#include "renderer/math/colour.h"
#include "tests/bsdf/bsdf_cases.h"

namespace candela {
namespace {

using tests::BsdfCase;
using tests::direction_of;

double ggx(double cos_h, double a) {
  const double base = cos_h * cos_h * (a * a - 1) + 1;
  return a * a / (pi_double * base * base);
}
double smith_lambda(double c, double a) {
  return 0.5 * (std::sqrt(1 + a * a * (1 / (c * c) - 1)) - 1);
}
double schlick_ggx(double c, double a) {
  const double k = (a + 1) * (a + 1) / 8;
  return c / (c * (1 - k) + k);
}

struct Pair {
  Vec3f wo;
  Vec3f wi;
};
std::vector<Pair> direction_pairs(bool is_transmitted) {
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < 512; ++i) {
    const Vec2f o = owen_sobol_2d(i, 11);
    const Vec2f n = owen_sobol_2d(i, 12);
    const Vec3f wi = direction_of(std::max(0.01f, n.x), 6.28f * n.y);
    pairs.push_back({direction_of(std::max(0.01f, o.x), 6.28f * o.y),
                     {wi.x, wi.y, is_transmitted ? -wi.z : wi.z}});
  }
  return pairs;
}

TEST(Unit_CookTorrance, IsTheReportsFormulaCorrected) {
  for (const GeometryTerm geometry : {GeometryTerm::SchlickGgx, GeometryTerm::Smith})
    for (const float a : {0.1f, 0.3f, 1.0f})
      for (const auto& [wo, wi] : direction_pairs(false)) {
        const Bsdf bsdf = tests::cook_torrance(a, Rgb{0.2f}, Rgb{0.8f}, Rgb{0.5f}, geometry);
        const Vec3d h = normalize(Vec3d(wo) + Vec3d(wi));
        const double ci = wi.z;
        const double co = wo.z;
        const double g = geometry == GeometryTerm::Smith
                             ? 1 / (1 + smith_lambda(ci, a) + smith_lambda(co, a))
                             : schlick_ggx(ci, a) * schlick_ggx(co, a);
        const double f = 0.5 + 0.5 * std::pow(1 - dot(h, Vec3d(wi)), 5);
        const double expected = 0.2 / pi_double + 0.8 * f * g * ggx(h.z, a) / (4 * ci * co);
        const float value = evaluate_bsdf(bsdf, wo, wi).value.x;
        ASSERT_NEAR(value, expected * ci, 1e-4 * expected * ci) << a;
      }
}

TEST(Unit_CookTorrance, IsZeroBelowTheSurface) {
  const Bsdf bsdf = tests::cook_torrance(0.3f, Rgb{0.2f}, Rgb{0.8f}, Rgb{0.5f}, {});
  EXPECT_EQ(evaluate_bsdf(bsdf, direction_of(0.5f, 0), {0.8f, 0, -0.6f}).pdf, 0);
  EXPECT_TRUE(is_black(evaluate_bsdf(bsdf, direction_of(0.5f, 0), {1, 0, 0}).value));
}

TEST(Unit_Lab, IsTheNormativeFormula) {
  const float exponent = 32;
  const float a = lab_width(exponent);
  EXPECT_FLOAT_EQ(a, std::sqrt(2.0f / 34));
  const Bsdf bsdf = tests::lab(a, Rgb{0.6f}, Rgb{0.3f});
  const auto schlick = [](double c) { return 0.3 + 0.7 * std::pow(1 - c, 5); };
  for (const auto& [wo, wi] : direction_pairs(false)) {
    const Vec3d h = normalize(Vec3d(wo) + Vec3d(wi));
    const double g = 1 / (1 + smith_lambda(wi.z, a) + smith_lambda(wo.z, a));
    const double expected = 0.6 * (1 - schlick(wi.z)) * (1 - schlick(wo.z)) / pi_double +
                            schlick(dot(h, Vec3d(wi))) * g * ggx(h.z, a) / (4.0 * wi.z * wo.z);
    ASSERT_NEAR(evaluate_bsdf(bsdf, wo, wi).value.x, expected * wi.z, 1e-4 * expected * wi.z);
  }
}

// Without a highlight it is Lambert's surface, and a faint one comes near to it continuously.
TEST(Unit_Lab, FaintHighlightIsNearlyDiffuse) {
  const Vec3f wo = direction_of(0.05f, 0);
  const Vec3f wi = direction_of(0.05f, 3.1f);
  const float lambert = 0.6f * wi.z * inverse_pi;
  EXPECT_FLOAT_EQ(evaluate_bsdf(tests::lab(0.3f, Rgb{0.6f}, Rgb{0}), wo, wi).value.x, lambert);
  EXPECT_NEAR(evaluate_bsdf(tests::lab(0.3f, Rgb{0.6f}, Rgb{1e-7f}), wo, wi).value.x, lambert,
              0.01f * lambert);
}

// [Walter07, eqs. 20 and 21] with indices of both sides, radiance seen from wo.
double walter_refraction(const Vec3d& o, const Vec3d& i, double n_o, double n_i, double a) {
  Vec3d h = -(n_o * o + n_i * i);
  h = normalize(h.z < 0 ? -h : h);
  const double oh = dot(o, h);
  const double ih = dot(i, h);
  if (oh <= 0 || ih >= 0) return 0;
  const double f =
      fresnel_dielectric(static_cast<float>(oh), static_cast<float>(n_i / n_o)).reflectance;
  const double g = 1 / ((1 + smith_lambda(o.z, a)) * (1 + smith_lambda(-i.z, a)));
  const double jacobian = n_o * n_o / std::pow(n_i * ih + n_o * oh, 2);
  return std::abs(ih * oh / (i.z * o.z)) * (1 - f) * g * ggx(h.z, a) * jacobian;
}

// Relative error of a refraction in float. Near the critical angle 1 - F goes as the cosine on the
// thin side, which is the square root of a difference that cancels: eps / cos^2.
double refraction_tolerance(const Vec3f& wo, const Vec3f& wi, float eta) {
  const Vec3d h = normalize(Vec3d(wo) + double{eta} * Vec3d(wi));
  const double cosine = std::min(std::abs(dot(h, Vec3d(wo))), std::abs(dot(h, Vec3d(wi))));
  return 3e-4 + 1e-6 / (cosine * cosine);
}

TEST(Unit_Dielectric, RefractionIsWaltersFormula) {
  for (const float eta : {1.5f, 1 / 1.5f, 1.1f, 3.0f})
    for (const float a : {0.1f, 0.5f})
      for (const auto& [wo, wi] : direction_pairs(true)) {
        const double expected =
            -wi.z * walter_refraction(Vec3d(wo), Vec3d(wi), 1, double{eta}, double{a});
        const float value = evaluate_bsdf(tests::dielectric(a, eta), wo, wi).value.x;
        ASSERT_NEAR(value, expected, refraction_tolerance(wo, wi, eta) * expected)
            << eta << " " << a;
      }
}

TEST(Unit_Bsdf, ReflectionsAreReciprocal) {
  for (const BsdfCase& c : tests::rough_cases())
    for (const auto& [wo, wi] : direction_pairs(false)) {
      const Rgb there = evaluate_bsdf(c.bsdf, wo, wi).value / wi.z;
      const Rgb back = evaluate_bsdf(c.bsdf, wi, wo).value / wo.z;
      for (int channel = 0; channel < 3; ++channel)
        ASSERT_NEAR(there[channel], back[channel], 1e-5f * there[channel]) << c.name;
    }
}

// f / eta_o^2 = f' / eta_i^2 [Veach97, eq. 5.14].
TEST(Unit_Dielectric, RefractionsAreReciprocalUpToEtaSquared) {
  for (const float eta : {1.5f, 0.5f, 1.1f, 2.4f})
    for (const float a : {0.1f, 0.6f})
      for (const auto& [wo, wi] : direction_pairs(true)) {
        const Vec3f other_wo{wi.x, wi.y, -wi.z};
        const Vec3f other_wi{wo.x, wo.y, -wo.z};
        const float there = evaluate_bsdf(tests::dielectric(a, eta), wo, wi).value.x / -wi.z;
        const float back =
            evaluate_bsdf(tests::dielectric(a, 1 / eta), other_wo, other_wi).value.x / wo.z;
        ASSERT_NEAR(there * square(eta), back, 2 * refraction_tolerance(wo, wi, eta) * back)
            << eta << " " << a;
      }
}

TEST(Unit_SmoothBsdf, LobesCarryWhatFresnelSays) {
  for (const float eta : {1.5f, 1 / 1.5f, 1.0f, 1000.0f, 1.0000001f})
    for (const float cos_o : {1.0f, 0.6f, 0.2f, 1e-3f}) {
      const Rgb tint{0.9f, 0.5f, 0.1f};
      const Bsdf bsdf = tests::dielectric(0, eta, tint);
      const Vec3f wo = direction_of(cos_o, 1);
      const DielectricFresnel fresnel = fresnel_dielectric(wo.z, eta);
      double reflected = 0;
      double refracted = 0;
      const int count = 4096;
      for (int i = 0; i < count; ++i) {
        const float lobe = (static_cast<float>(i) + 0.5f) / count;
        const BsdfSample sample = sample_bsdf(bsdf, wo, lobe, {0.3f, 0.4f});
        ASSERT_TRUE(sample.is_delta && sample.pdf == 0);
        (sample.wi.z < 0 ? refracted : reflected) += sample.weight.y / count;
        if (sample.wi.z > 0) continue;
        ASSERT_NEAR(length_squared(sample.wi), 1, 1e-6);
        ASSERT_NEAR(sample.wi.x * eta, -wo.x, 2e-4);  // Snell
      }
      EXPECT_NEAR(reflected, fresnel.reflectance, 2.0 / count);
      const double expected = 0.5 * (1 - fresnel.reflectance) / square(double{eta});
      EXPECT_NEAR(refracted, expected, 2.0 / count * std::max(1.0, 1 / square(double{eta})));
    }
}

TEST(Unit_SmoothBsdf, PaneSumsItsInterreflections) {
  const Bsdf pane{.model = BsdfModel::ThinDielectric, .eta = Rgb{1.5f}, .transmittance = Rgb{0.8f}};
  const float cos_o = 0.4f;
  const double f = fresnel_dielectric(cos_o, 1.5f).reflectance;
  // Bounce by bounce; the tint counts once a crossing.
  double reflected = f;
  double transmitted = 0;
  double inside = (1 - f);
  for (int i = 0; i < 50; ++i) {
    (i % 2 == 0 ? transmitted : reflected) += inside * (1 - f) * 0.64;
    inside *= f;
  }
  const PaneReflectance sum = pane_reflectance(pane, cos_o);
  EXPECT_NEAR(sum.reflected.x, reflected, 1e-6);
  EXPECT_NEAR(sum.transmitted.x, transmitted, 1e-6);
  const Vec3f wo = direction_of(cos_o, 1);
  const BsdfSample through = sample_bsdf(pane, wo, 0.99f, {});
  EXPECT_EQ(through.wi, -wo);
  EXPECT_EQ(through.eta, 1);
  const Bsdf clear{.model = BsdfModel::ThinDielectric, .eta = Rgb{1.5f}};
  const PaneReflectance all = pane_reflectance(clear, cos_o);
  EXPECT_NEAR(all.reflected.x + all.transmitted.x, 1, 1e-6);
}

// Rough glass that is nearly smooth carries what smooth glass carries, also in radiance.
TEST(Unit_Dielectric, RoughGoesOverIntoSmooth) {
  for (const float eta : {1.5f, 1 / 1.5f})
    for (const float cos_o : {0.95f, 0.5f}) {
      const Vec3f wo = direction_of(cos_o, 1);
      double rough = 0;
      double smooth = 0;
      for (std::uint32_t i = 0; i < 4096; ++i) {
        const float lobe = owen_sobol_1d(i, 1);
        rough += sample_bsdf(tests::dielectric(1e-3f, eta), wo, lobe, owen_sobol_2d(i, 2)).weight.x;
        smooth += sample_bsdf(tests::dielectric(0, eta), wo, lobe, {}).weight.x;
      }
      EXPECT_NEAR(rough, smooth, 2e-3 * smooth);
    }
}

template <ModelSet models>
void expect_same_as_general(const Bsdf& bsdf) {
  for (std::uint32_t i = 0; i < 64; ++i) {
    const Vec3f wo = direction_of(0.5f, 0.1f * static_cast<float>(i));
    const BsdfSample general = sample_bsdf(bsdf, wo, owen_sobol_1d(i, 1), owen_sobol_2d(i, 2));
    const BsdfSample pruned =
        sample_bsdf<models>(bsdf, wo, owen_sobol_1d(i, 1), owen_sobol_2d(i, 2));
    ASSERT_EQ(general.wi, pruned.wi);
    ASSERT_EQ(general.weight, pruned.weight);
    ASSERT_EQ(general.pdf, pruned.pdf);
    ASSERT_EQ(evaluate_bsdf(bsdf, wo, general.wi).value,
              evaluate_bsdf<models>(bsdf, wo, general.wi).value);
  }
}

TEST(Unit_BsdfDispatch, PrunedSwitchesGiveTheSameBits) {
  expect_same_as_general<model_bit(BsdfModel::CookTorrance)>(
      tests::cook_torrance(0.3f, Rgb{0.2f}, Rgb{0.8f}, Rgb{0.5f}, {}));
  expect_same_as_general<model_bit(BsdfModel::Lab) | model_bit(BsdfModel::Diffuse)>(
      tests::lab(0.3f, Rgb{0.2f}, Rgb{0.8f}));
  expect_same_as_general<model_bit(BsdfModel::Dielectric)>(tests::dielectric(0.3f, 1.5f));
  const Bsdf outside = tests::conductor(0.3f);
  constexpr ModelSet two = model_bit(BsdfModel::Diffuse) | model_bit(BsdfModel::Mirror);
  EXPECT_EQ(evaluate_bsdf<two>(outside, {0, 0, 1}, {0, 0, 1}).pdf, 0);
}

TEST(Unit_BsdfDispatch, KnowsDeltaModels) {
  EXPECT_TRUE(is_only_delta(tests::dielectric(0, 1.5f)));
  EXPECT_TRUE(is_only_delta({.model = BsdfModel::Mirror}));
  EXPECT_FALSE(is_only_delta(tests::conductor(0.3f)));
}

}  // namespace
}  // namespace candela
