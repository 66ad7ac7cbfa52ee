// --sampling: plain directions, and what each strategy cannot see.
#include <gtest/gtest.h>

#include "integrators/plain_direction.h"
#include "integrators/render.h"
#include "renderer/sampling/sobol.h"
#include "tests/bsdf/bsdf_cases.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/direction_sampling.h"
#include "tests/statistics/distributions.h"
#include "tests/statistics/moments.h"

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

constexpr SamplingStrategy all_strategies[] = {SamplingStrategy::Mis, SamplingStrategy::Light,
                                               SamplingStrategy::Bsdf, SamplingStrategy::Cosine,
                                               SamplingStrategy::Uniform};

description::SceneDescription with_ball_of(description::MaterialHandle material,
                                           description::SceneDescription scene) {
  add_mesh(scene, sphere({0, 0, 0}, 0.3, 3), material);
  return scene;
}

template <class Model>
void expect_accepted(Model model) {
  description::SceneDescription scene = small_room();
  const auto material = add_material(scene, model);
  for (const SamplingStrategy strategy : all_strategies)
    EXPECT_EQ(sentences(with_ball_of(material, scene), strategy), "");
}

template <class Model>
void expect_refused(Model model, std::string_view verb = "is") {
  description::SceneDescription scene = small_room();
  const auto material = add_material(scene, model);
  scene.materials.back().name = "odd";
  for (const SamplingStrategy strategy : all_strategies) {
    EXPECT_EQ(sentences(scene, strategy), "") << "nothing wears the material";
    const std::string expected =
        samples_bsdfs(strategy)
            ? ""
            : fmt::format(
                  "error: material 'odd' {} smoothly coated, and sampling by '{}' does not "
                  "follow the coat's reflection; expected mis, bsdf or light\n",
                  verb, name_of(strategy));
    EXPECT_EQ(sentences(with_ball_of(material, scene), strategy), expected);
  }
}

TEST(Errors_SamplingStrategy, NamesTheSmoothCoat) {
  expect_refused(description::CoatedDiffuseMaterial{});
  description::CoatedConductorMaterial brushed;
  brushed.roughness.factor = 0.3;
  expect_refused(brushed);
}

TEST(Errors_SamplingStrategy, AsksForTheLargerWidthOfACoat) {
  description::CoatedDiffuseMaterial combed;
  combed.coat.roughness_across = description::ScalarInput{0.3, {}, 0};
  expect_accepted(combed);
  combed.coat.roughness_across->factor = 1e-5;
  expect_refused(combed);
}

TEST(Errors_SamplingStrategy, AMapMayBeSmoothSomewhere) {
  description::CoatedDiffuseMaterial stained;
  stained.coat.roughness.map = description::ImageHandle(0);
  expect_refused(stained, "may be");
}

TEST(Errors_SamplingStrategy, ATextureMayBeSmoothSomewhere) {
  description::SceneDescription scene = small_room();
  scene.textures.push_back({"squares", {}, description::CheckerboardTexture{}});
  description::CoatedDiffuseMaterial squared;
  squared.coat.roughness.texture = description::TextureHandle(0);
  const auto material = add_material(scene, squared);
  EXPECT_NE(sentences(with_ball_of(material, scene), SamplingStrategy::Cosine).find("may be"),
            std::string::npos);
}

// One delta lobe is followed as it is.
TEST(Errors_SamplingStrategy, NamesNoCoatOverWhatIsSmoothItself) {
  expect_accepted(description::CoatedConductorMaterial{});
}

TEST(Errors_SamplingStrategy, AreNoneForRoughCoatsAndForDeltaLobesAlone) {
  description::SceneDescription scene = small_room();
  description::CoatedDiffuseMaterial rough;
  rough.coat.roughness.factor = 0.2;
  for (const auto material :
       {add_material(scene, rough), add_material(scene, description::MirrorMaterial{}),
        add_material(scene, description::ConductorMaterial{}),
        add_material(scene, description::DielectricMaterial{})})
    for (const SamplingStrategy strategy : all_strategies)
      EXPECT_EQ(sentences(with_ball_of(material, scene), strategy), "");
}

// What no strategy refuses is the same picture by each: in mirrors and through glass, and, by those
// with BSDF samples, in smooth coats.
TEST(Statistical_SamplingStrategy, SamePictureWithDeltaLobes) {
  description::SceneDescription scene = small_room();
  const auto coated = add_material(scene, description::CoatedDiffuseMaterial{});
  for (const auto material : {add_material(scene, description::MirrorMaterial{}),
                              add_material(scene, description::DielectricMaterial{}), coated}) {
    const description::SceneDescription with_ball = with_ball_of(material, scene);
    const auto means_by = [&](SamplingStrategy strategy) {
      statistics::Moments means;
      for (std::uint64_t seed = 1; seed <= 16; ++seed) {
        RenderSettings settings = settings_of(24, 64, seed);
        settings.options.sampling = strategy;
        settings.options.crop = PixelRect{8, 8, 16, 16};  // the ball
        const Scene compiled_scene = compiled(with_ball, settings.options);
        means.add(mean_of(picture(compiled_scene, settings)));
      }
      return means;
    };
    const statistics::Moments by_mis = means_by(SamplingStrategy::Mis);
    for (const SamplingStrategy strategy :
         {SamplingStrategy::Light, SamplingStrategy::Cosine, SamplingStrategy::Uniform}) {
      if (!samples_bsdfs(strategy) && material.index == coated.index) continue;
      const statistics::Moments means = means_by(strategy);
      EXPECT_LT(means.standard_error(), 0.03 * means.mean());
      EXPECT_GT(welch_p_value(by_mis, means), 0.001)
          << name_of(strategy) << " " << by_mis.mean() << " " << means.mean();
    }
  }
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
  // Of sequences with random numbers of their own.
  const auto albedos_by = [](std::uint64_t first_key, const auto& weight_of) {
    statistics::Moments albedos;
    for (std::uint64_t key = first_key; key < first_key + 32; key += 2) {
      constexpr std::uint32_t count = 1 << 14;
      double sum = 0;
      for (std::uint32_t i = 0; i < count; ++i)
        sum +=
            double{weight_of(owen_sobol_1d(i, mix_bits(key)), owen_sobol_2d(i, mix_bits(key + 1)))};
      albedos.add(sum / count);
    }
    return albedos;
  };
  for (const tests::BsdfCase& c : tests::rough_cases()) {
    SCOPED_TRACE(c.name);
    if (!c.bsdf.is_smooth && c.bsdf.alpha < 0.2f && c.bsdf.model != BsdfModel::Diffuse) continue;
    // From within glass the light that leaves grazingly is rarely drawn: too few directions here.
    if (c.bsdf.model == BsdfModel::AnisotropicDielectric && c.bsdf.eta.x < 1) continue;
    const statistics::Moments own = albedos_by(
        1, [&](float choice, Vec2f u) { return sample_bsdf(c.bsdf, wo, choice, u).weight.y; });
    for (const SamplingStrategy strategy : {SamplingStrategy::Cosine, SamplingStrategy::Uniform}) {
      const statistics::Moments plain = albedos_by(33, [&](float choice, Vec2f u) {
        return sample_plain_direction(strategy, c.bsdf, wo, choice, u).weight.y;
      });
      EXPECT_LT(plain.standard_error(), 0.01) << static_cast<int>(strategy);
      EXPECT_GT(welch_p_value(own, plain), 0.001)
          << static_cast<int>(strategy) << " " << own.mean() << " " << plain.mean();
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
