// --sampling: plain directions, and what each strategy cannot see.
#include <gtest/gtest.h>

#include "integrators/plain_direction.h"
#include "integrators/render.h"
#include "renderer/sampling/sobol.h"
#include "tests/bsdf/bsdf_cases.h"
#include "tests/scenes/description.h"
#include "tests/statistics/direction_sampling.h"
#include "tests/statistics/distributions.h"

namespace candela {
namespace {

using namespace test;

std::string sentences(const description::SceneDescription& scene, SamplingStrategy strategy) {
  RenderOptions options;
  options.sampling = strategy;
  const Diagnostics diagnostics = check_integrator(scene, options);
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics.list()) text += to_string(diagnostic) + "\n";
  return text;
}

constexpr SamplingStrategy blind_to_delta_lobes[] = {
    SamplingStrategy::Light, SamplingStrategy::Cosine, SamplingStrategy::Uniform};

template <class Model>
void expect_unseen(Model model, const std::string& lobe) {
  description::SceneDescription scene = small_room();
  const auto material = add_material(scene, model);
  scene.materials.back().name = "odd";
  for (const SamplingStrategy strategy : blind_to_delta_lobes)
    EXPECT_EQ(sentences(scene, strategy), "") << "nothing wears the material";
  add_mesh(scene, sphere({0, 0, 0}, 0.1, 1), material);
  for (const SamplingStrategy strategy : blind_to_delta_lobes)
    EXPECT_NE(sentences(scene, strategy).find("material 'odd' is " + lobe + ", in which"),
              std::string::npos)
        << sentences(scene, strategy);
  for (const SamplingStrategy strategy : {SamplingStrategy::Bsdf, SamplingStrategy::Mis})
    EXPECT_EQ(sentences(scene, strategy), "");
}

TEST(Errors_SamplingStrategy, NamesTheDeltaLobe) {
  expect_unseen(description::MirrorMaterial{}, "a mirror");
  expect_unseen(description::ConductorMaterial{}, "a smooth conductor");
  expect_unseen(description::DielectricMaterial{}, "a smooth dielectric");
  description::DielectricMaterial rough;
  rough.roughness.factor = 0.2;
  description::SceneDescription scene = small_room();
  add_mesh(scene, sphere({0, 0, 0}, 0.1, 1), add_material(scene, rough));
  for (const SamplingStrategy strategy : blind_to_delta_lobes)
    EXPECT_EQ(sentences(scene, strategy), "");
}

TEST(Errors_SamplingStrategy, NamesTheDeltaLight) {
  description::SceneDescription scene = small_room();
  add_light(scene, description::PointLight{{0, 0, 0}, Vec3d(0.0)});
  EXPECT_EQ(sentences(scene, SamplingStrategy::Bsdf), "") << "it is black";
  add_light(scene, description::PointLight{{0, 0, 0}, Vec3d(1.0)});
  EXPECT_EQ(sentences(scene, SamplingStrategy::Bsdf),
            "error: the scene has a point light, which sampling by 'bsdf' never meets; expected "
            "mis, light, cosine or uniform\n");
  EXPECT_EQ(sentences(scene, SamplingStrategy::Light), "");
}

// Of every rough model, through glass as well: sum of value / pdf over directions is the albedo.
TEST(Statistical_PlainDirection, HasTheAlbedoOfTheBsdfsOwnSampling) {
  const Vec3f wo = normalize(Vec3f{0.5f, 0.2f, 0.7f});
  constexpr std::uint32_t count = 1 << 18;
  for (const tests::BsdfCase& c : tests::rough_cases()) {
    SCOPED_TRACE(c.name);
    if (!c.bsdf.is_smooth && c.bsdf.alpha < 0.2f && c.bsdf.model != BsdfModel::Diffuse) continue;
    // From within glass the light that leaves grazingly is rarely drawn: too few directions here.
    if (c.bsdf.model == BsdfModel::AnisotropicDielectric && c.bsdf.eta.x < 1) continue;
    double own = 0;
    for (std::uint32_t i = 0; i < count; ++i)
      own += double{sample_bsdf(c.bsdf, wo, owen_sobol_1d(i, 1), owen_sobol_2d(i, 2)).weight.y};
    for (const SamplingStrategy strategy : {SamplingStrategy::Cosine, SamplingStrategy::Uniform}) {
      double plain = 0;
      for (std::uint32_t i = 0; i < count; ++i)
        plain += double{
            sample_plain_direction(strategy, c.bsdf, wo, owen_sobol_1d(i, 3), owen_sobol_2d(i, 4))
                .weight.y};
      EXPECT_NEAR(plain / count, own / count, 0.004) << static_cast<int>(strategy);
    }
  }
}

// Over a hemisphere, or both where light goes through.
TEST(Statistical_PlainDirection, DirectionsFollowTheirDensity) {
  const Vec3f wo = normalize(Vec3f{0.5f, 0.2f, 0.7f});
  const Bsdf opaque{.model = BsdfModel::Diffuse, .diffuse = Rgb{0.5f}};
  for (const Bsdf& bsdf : {opaque, tests::dielectric(0.6f, 1.5f)})
    for (const SamplingStrategy strategy : {SamplingStrategy::Cosine, SamplingStrategy::Uniform}) {
      const bool is_opaque = bsdf.model == BsdfModel::Diffuse;
      const auto density = [&](const Vec3f& wi) {
        const double cosine = is_opaque ? wi.z : std::abs(wi.z);
        if (!(cosine > 0)) return 0.0;
        const double hemisphere = strategy == SamplingStrategy::Cosine ? 2 * cosine : 1;
        return hemisphere / (is_opaque ? 2 : 4) / pi_double;
      };
      const auto result = statistics::test_directions(
          [&](float side, Vec2f u) -> std::optional<Vec3f> {
            return sample_plain_direction(strategy, bsdf, wo, side, u).wi;
          },
          density, {}, 17, 300'000);
      EXPECT_GT(result.chi_square.p_value, statistics::sidak_level(0.01, 4))
          << is_opaque << ' ' << name_of(strategy) << ' ' << result.chi_square.message;
    }
}

}  // namespace
}  // namespace candela
