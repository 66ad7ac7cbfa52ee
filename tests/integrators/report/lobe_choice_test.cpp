// REPORT 3.10: what may be divided by what where a surface has two lobes.
#include <gtest/gtest.h>

#include "integrators/report/ggx_half_vector.h"
#include "renderer/bsdf/dispatch.h"
#include "renderer/sampling/hash.h"
#include "tests/bsdf/bsdf_cases.h"
#include "tests/statistics/direction_sampling.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

constexpr float p_specular = 0.6f;

const Bsdf& surface() {
  static const Bsdf bsdf =
      tests::cook_torrance(0.3f, Rgb{0.2f}, Rgb{0.8f}, Rgb{0.57f}, GeometryTerm::SchlickGgx);
  return bsdf;
}
const Vec3f wo = tests::direction_of(0.6f, 0.2f);

// A direction from the lobe that was picked, and what each bookkeeping needs to know of it.
struct Sample {
  double f_cosine = 0;  // of both lobes
  double lobe_pdf = 0;  // of the picked lobe
  double lobe_probability = 0;
  double mixture_pdf = 0;
};

Sample sample_of(std::uint32_t i) {
  const std::uint64_t bits = mix_bits(i + 1);
  const float choice = unit_float(static_cast<std::uint32_t>(mix_bits(bits)));
  const Vec2f u{unit_float(static_cast<std::uint32_t>(bits)),
                unit_float(static_cast<std::uint32_t>(bits >> 32))};
  const float a = surface().alpha;
  const bool is_specular = choice < p_specular;
  const Vec3f wi = is_specular ? reflect_about(wo, sample_ggx_half_vector(a, u))
                               : square_to_cosine_hemisphere(u);
  const double specular_pdf = ggx_half_vector_pdf(wo, wi, a);
  const double diffuse_pdf = cosine_hemisphere_pdf(wi.z);
  if (!(wi.z > 0)) return {0, 1, 1, 1};
  return {evaluate_bsdf(surface(), wo, wi).value.y, is_specular ? specular_pdf : diffuse_pdf,
          is_specular ? p_specular : 1 - p_specular,
          p_specular * specular_pdf + (1 - p_specular) * diffuse_pdf};
}

template <class Weight>
statistics::Moments moments_of(Weight weight) {
  statistics::Moments moments;
  for (std::uint32_t i = 0; i < 400'000; ++i) moments.add(weight(sample_of(i)));
  return moments;
}

double albedo() {
  return statistics::integrate_sphere(
      [](const Vec3f& wi) { return evaluate_bsdf(surface(), wo, wi).value.y; }, {});
}

// The full f over the full density of the mixture: what candela does.
TEST(Statistical_ReportLobes, MixtureDensityIsUnbiased) {
  EXPECT_GT(
      moments_of([](const Sample& s) { return s.f_cosine / s.mixture_pdf; }).p_value(albedo()),
      0.01);
}

// "Pick a lobe, evaluate all of f, divide by that lobe's probability and density" counts every
// direction once a lobe: twice too bright.
TEST(Statistical_ReportLobes, OneLobesDensityUnderAllOfFIsBiased) {
  const auto slip =
      moments_of([](const Sample& s) { return s.f_cosine / (s.lobe_probability * s.lobe_pdf); });
  EXPECT_LT(slip.p_value(albedo()), 1e-12);
  EXPECT_GT(slip.p_value(2 * albedo()), 0.01);
}

// Without the lobe's probability each lobe estimates all of f on its own, which is unbiased, since
// both densities cover the hemisphere; it is only noisier than the mixture.
TEST(Statistical_ReportLobes, EachLobeAloneIsUnbiasedButNoisier) {
  const auto alone = moments_of([](const Sample& s) { return s.f_cosine / s.lobe_pdf; });
  const auto mixture = moments_of([](const Sample& s) { return s.f_cosine / s.mixture_pdf; });
  EXPECT_GT(alone.p_value(albedo()), 0.01);
  EXPECT_GT(alone.variance(), 2 * mixture.variance());
}

}  // namespace
}  // namespace candela
