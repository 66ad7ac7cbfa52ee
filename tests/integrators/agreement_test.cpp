// All settings that claim to be unbiased give the same picture: every pair of them, on the metal
// and on the diffuse Cornell box. A new setting is one line in all_settings().
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene_io/load.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/distributions.h"
#include "tests/statistics/replicates.h"

namespace candela {
namespace {

using statistics::Replicates;
using test::RenderSettings;

constexpr int size = 24;
constexpr int replicate_count = 16;
constexpr int samples_per_pixel = 32;

struct Setting {
  std::string name;
  void (*apply)(RenderSettings&);
};

// Each estimator of path alone. Lamps that only directions find leave heavy tails, which the t
// distribution knows nothing of: more samples, until the means are normal.
std::vector<Setting> strategies() {
  return {
      {"path, light", [](RenderSettings& s) { s.options.sampling = SamplingStrategy::Light; }},
      {"path, bsdf",
       [](RenderSettings& s) {
         s.options.sampling = SamplingStrategy::Bsdf;
         s.options.samples_per_pixel = 1024;
       }},
      {"path, cosine", [](RenderSettings& s) { s.options.sampling = SamplingStrategy::Cosine; }},
      {"path, uniform", [](RenderSettings& s) { s.options.sampling = SamplingStrategy::Uniform; }},
      {"path, balance", [](RenderSettings& s) { s.options.heuristic = Heuristic::Balance; }},
      {"path, light, BVH",
       [](RenderSettings& s) {
         s.options.sampling = SamplingStrategy::Light;
         s.accelerator = AcceleratorKind::Bvh;
       }},
  };
}

std::vector<Setting> all_settings() {
  std::vector<Setting> settings = {
      {"path, Embree", [](RenderSettings&) {}},
      {"path, BVH", [](RenderSettings& s) { s.accelerator = AcceleratorKind::Bvh; }},
      {"report, Embree", [](RenderSettings& s) { s.options.integrator = IntegratorKind::Report; }},
      {"report with P_RR = .6, BVH",
       [](RenderSettings& s) {
         s.options.integrator = IntegratorKind::Report;
         s.options.report_p_rr = 0.6f;
         s.accelerator = AcceleratorKind::Bvh;
       }},
      {"report, uniform",
       [](RenderSettings& s) {
         s.options.integrator = IntegratorKind::Report;
         s.options.sampling = SamplingStrategy::Uniform;
       }},
  };
  for (Setting& setting : strategies()) settings.push_back(std::move(setting));
  return settings;
}

description::SceneDescription cornell_box(const std::string& name) {
  Result<description::SceneDescription> description =
      load(fmt::format("{}/assets/{}/{}.yaml", CANDELA_SOURCE_DIR, name, name), {});
  EXPECT_TRUE(description);
  return std::move(*description);
}

Scene compiled(const description::SceneDescription& description) {
  return test::compiled(description, test::settings_of(size, 1).options);
}

// Seeds of their own for each setting: common random numbers would hide what they share.
Replicates replicates_of(const Scene& scene, const Setting& setting, std::uint64_t first_seed) {
  RenderSettings settings = test::settings_of(size, samples_per_pixel);
  setting.apply(settings);
  Replicates replicates{setting.name, size, size, {}};
  for (int i = 0; i < replicate_count; ++i) {
    settings.options.seed = first_seed + static_cast<std::uint64_t>(i);
    replicates.images.push_back(test::grey(test::rendered(scene, settings).film.to_image(false)));
  }
  return replicates;
}

void expect_all_agree(const Scene& scene, const std::vector<Setting>& settings) {
  std::vector<Replicates> all;
  for (const Setting& setting : settings)
    all.push_back(replicates_of(scene, setting, 1000 * (all.size() + 1)));
  const auto pairs = static_cast<double>(all.size() * (all.size() - 1) / 2);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto agreement =
          compare_replicates(all[i], all[j], {.level = statistics::sidak_level(0.01, pairs)});
      EXPECT_TRUE(agreement.passed) << agreement.message;
    }
}

TEST(Statistical_UnbiasedSettings, AgreeOnTheMetalCornellBox) {
  expect_all_agree(compiled(cornell_box("cornell_box")), all_settings());
}

TEST(Statistical_UnbiasedSettings, AgreeOnTheDiffuseCornellBox) {
  expect_all_agree(compiled(cornell_box("cornell_box_diffuse")), all_settings());
}

// The metal with the light of multiple bounces between its facets, too. Without directions alone:
// on the ceiling, which the lamp does not reach, they would need ten thousand samples a pixel.
TEST(Statistical_UnbiasedSettings, AgreeOnCompensatedMetal) {
  description::SceneDescription scene = cornell_box("cornell_box");
  for (description::Material& material : scene.materials)
    if (auto* metal = std::get_if<description::CookTorranceMaterial>(&material.model)) {
      metal->geometry = description::GeometryModel::Smith;
      metal->energy_compensation = true;
      metal->roughness.factor = 0.7;
    }
  std::vector<Setting> settings = all_settings();
  std::erase_if(settings, [](const Setting& setting) { return setting.name == "path, bsdf"; });
  expect_all_agree(compiled(scene), settings);
}

// Light from everywhere. (Not through glass: there plain directions hit upon weights of 10^4 once
// in 10^5 samples, and no t distribution knows of that. sampling_strategy_test.cpp holds their
// albedo.)
TEST(Statistical_UnbiasedSettings, StrategiesAgreeUnderASky) {
  description::SceneDescription scene = test::small_room();
  for (description::Material& material : scene.materials) material.emission = Vec3d(0.0);
  description::CookTorranceMaterial metal;
  metal.roughness.factor = 0.4;
  metal.f0 = Vec3d(0.6);
  test::add_mesh(scene, test::sphere({0, 0, 0.2}, 0.5, 3), test::add_material(scene, metal));
  test::add_light(scene, description::ConstantEnvironment{{0.5, 0.7, 1.0}, true});
  std::vector<Setting> settings = strategies();
  settings.push_back({"path", [](RenderSettings&) {}});
  expect_all_agree(compiled(scene), settings);
}

// What the test can see: paths cut after four bounces, and light that is 3 % too dim.
TEST(Statistical_UnbiasedSettings, BiasIsSeen) {
  const Scene scene = compiled(cornell_box("cornell_box"));
  const Replicates path = replicates_of(scene, {"path", [](RenderSettings&) {}}, 1);
  const Replicates cut =
      replicates_of(scene, {"cut", [](RenderSettings& s) { s.options.max_depth = 4; }}, 101);
  Replicates dim = replicates_of(scene, {"dim", [](RenderSettings&) {}}, 201);
  for (auto& image : dim.images)
    for (double& value : image) value *= 0.97;
  for (const Replicates& biased : {cut, dim}) {
    const auto agreement = compare_replicates(biased, path);
    EXPECT_FALSE(agreement.passed) << agreement.message;
    EXPECT_LT(agreement.whole_p_value, 1e-4);
  }
}

}  // namespace
}  // namespace candela
