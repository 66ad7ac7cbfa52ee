// Guided pictures: right in expectation, the same bits, less noise where light is hard to find, and
// not guided where that does not pay.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "renderer/image/compare.h"
#include "scene_io/load.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/moments.h"
#include "tests/statistics/replicates.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

// Two rooms, and in the wall between them a gap; a lamp in the far one that only its walls see.
SceneDescription rooms_with_a_gap() {
  SceneDescription scene = empty_scene();
  const auto white = add_material(scene, diffuse(Vec3d(0.7)));
  const auto lamp = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(60.0));
  add_mesh(scene, inside_out(box({-1, -1, -3}, {1, 1, 1})), white);
  add_mesh(scene, box({-1, -1, -1.05}, {0.85, 1, -1}), white);
  add_mesh(scene, quad({-0.6, 0.95, -2.5}, {0.5, 0, 0}, {0, 0, 0.5}), lamp);
  set_camera(scene, {0, 0, 0.9}, {0, -0.1, 0}, 80);
  return scene;
}

// The same with whatever paths may meet.
SceneDescription rooms_of_kinds() {
  SceneDescription scene = rooms_with_a_gap();
  description::CookTorranceMaterial glossy;
  glossy.diffuse.factor = Vec3d(0.3);
  glossy.specular.factor = Vec3d(0.5);
  glossy.roughness.factor = 0.3;
  add_mesh(scene, sphere({-0.4, -0.6, 0}, 0.35, 3), add_material(scene, glossy));
  add_mesh(scene, quad({0.3, -0.95, 0.2}, {0.5, 0, -0.3}, {0, 0.9, 0}),
           add_material(scene, description::MirrorMaterial{}));
  add_mesh(scene, quad({-0.9, -0.9, -0.6}, {0.5, 0, 0.1}, {0, 0.8, 0}),
           add_material(scene, description::DiffuseTransmissionMaterial{}));
  add_mesh(scene, quad({-0.3, -0.95, 0.3}, {0.4, 0, 0.2}, {0, 0.6, -0.2}),
           add_material(scene, description::CoatedDiffuseMaterial{}));
  description::DielectricMaterial glass;
  add_mesh(scene, sphere({0.2, -0.7, -0.4}, 0.25, 3), add_material(scene, glass));
  add_light(scene, description::PointLight{{0.3, 0.5, -2}, Vec3d(1)});
  return scene;
}

// A dark room with a strong lamp at a wall, as large as paths find it by themselves: light samples
// and guided directions share it.
SceneDescription room_with_a_panel() {
  SceneDescription scene = furnace(inside_out(box({-1, -1, -1}, {1, 1, 1})), 0.3, 0);
  add_mesh(scene, quad({-0.95, -0.4, -0.8}, {0, 0.8, 0}, {0, 0, 0.8}),
           add_material(scene, diffuse(Vec3d(0.0)), Vec3d(5.0)));
  add_mesh(scene, quad({-1, -0.9, 1}, {2, 0, 0}, {0, 0, -2}),
           add_material(scene, description::CoatedDiffuseMaterial{}));  // mirrors it, too
  set_camera(scene, {0.9, 0, 0.9}, {-0.5, -0.5, -0.5}, 70);
  return scene;
}

// Light comes from everywhere: guides have nothing to find.
SceneDescription evenly_lit() {
  return furnace(inside_out(box({-1, -1, -1}, {1, 1, 1})), 0.5, 0.25);
}

RenderSettings guided_settings(int size, int samples, Guiding guiding, std::uint64_t seed = 1) {
  RenderSettings settings = settings_of(size, samples, seed);
  settings.options.guiding = guiding;
  settings.options.plan.roulette_threshold = 0.25f;
  return settings;
}

// `is_hard`: paths must be guided for the test to see anything.
statistics::Replicates replicates_of(const Scene& scene, Guiding guiding, bool is_hard,
                                     std::uint64_t first) {
  constexpr int size = 24;
  statistics::Replicates replicates{
      guiding == Guiding::On ? "guided" : "not guided", size, size, {}};
  for (std::uint64_t i = 0; i < 16; ++i) {
    const auto result = rendered(scene, guided_settings(size, 160, guiding, first + i));
    if (is_hard) {
      EXPECT_EQ(result.statistics.guiding.cells > 0, guiding == Guiding::On);
    }
    EXPECT_EQ(result.statistics.invalid_samples, 0u);
    replicates.images.push_back(grey(result.film.to_image(false)));
  }
  return replicates;
}

void expect_same_expectation(const SceneDescription& description, bool is_hard) {
  const Scene scene = compiled(description, guided_settings(24, 160, Guiding::On).options);
  const auto agreement = compare_replicates(replicates_of(scene, Guiding::On, is_hard, 100),
                                            replicates_of(scene, Guiding::Off, is_hard, 200));
  EXPECT_TRUE(agreement.passed) << agreement.message;
  EXPECT_NEAR(agreement.whole_ratio, 1, 0.03) << "the test sees too little";
}

TEST(Statistical_Guiding, KeepsTheExpectation) {
  expect_same_expectation(rooms_with_a_gap(), true);
  expect_same_expectation(rooms_of_kinds(), true);
  expect_same_expectation(room_with_a_panel(), true);
  SceneDescription open = small_room();
  add_light(open, description::ConstantEnvironment{Vec3d(0.4), true});
  expect_same_expectation(open, false);
}

TEST(Statistical_Guiding, KeepsTheExpectationOfAssets) {
  for (const std::string name : {"cornell_box", "glass_and_metal"}) {
    const auto scene =
        load(fmt::format("{}/assets/{}/{}.yaml", CANDELA_SOURCE_DIR, name, name), {});
    ASSERT_TRUE(scene);
    expect_same_expectation(*scene, false);
  }
}

// Every direction brings the same: guides are as wrong as may be, and the mean stays what it is.
TEST(Statistical_Guiding, KeepsTheFurnace) {
  const auto result = rendered(evenly_lit(), guided_settings(24, 256, Guiding::On));
  EXPECT_NEAR(mean_of(result.film.to_image(false)), 0.5, 0.002);
}

double error_of(const Scene& scene, Guiding guiding, std::uint64_t seed, const Image& right) {
  return compare_images(picture(scene, guided_settings(right.width, 256, guiding, seed)), right)
      ->relmse;
}

TEST(Statistical_Guiding, LowersTheErrorBehindAGap) {
  const Scene scene = compiled(rooms_with_a_gap(), guided_settings(32, 256, Guiding::On).options);
  const Image right = picture(scene, guided_settings(32, 4096, Guiding::On, 77));
  statistics::Moments gain;  // as a logarithm
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    gain.add(std::log(error_of(scene, Guiding::Off, seed, right) /
                      error_of(scene, Guiding::On, seed, right)));
  EXPECT_GT(gain.interval(0.95).low, 0) << std::exp(gain.mean());
}

TEST(Agreement_Guiding, SameBitsOverThreadsTilesAndCrops) {
  for (const Guiding guiding : {Guiding::On, Guiding::Auto}) {
    RenderSettings settings = guided_settings(64, 256, guiding, 2);  // by which trials choose them
    settings.options.crop = PixelRect{10, 0, 42, 44};
    const Scene scene = compiled(rooms_with_a_gap(), settings.options);
    const RenderResult result = rendered(scene, settings);
    EXPECT_GT(result.statistics.guiding.guided_cells, 0u);
    expect_same_bits_however_rendered(scene, settings, result.film.to_image(true), {13, 5, 30, 40});
  }
}

// The reference BVH teaches the same, and its pictures are guided as well.
TEST(Agreement_Guiding, ReferenceBvhAgrees) {
  const auto settings_for = [](AcceleratorKind accelerator, std::uint64_t seed) {
    RenderSettings settings = guided_settings(32, 128, Guiding::On, seed);
    settings.accelerator = accelerator;
    return settings;
  };
  const Scene scene = compiled(rooms_with_a_gap(), settings_for(AcceleratorKind::Bvh, 1).options);
  statistics::Moments embree;
  statistics::Moments bvh;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    embree.add(mean_of(picture(scene, settings_for(AcceleratorKind::Embree, seed))));
    const RenderResult result = rendered(scene, settings_for(AcceleratorKind::Bvh, 50 + seed));
    EXPECT_GT(result.statistics.guiding.guided_cells, 0u);
    bvh.add(mean_of(result.film.to_image(true)));
  }
  EXPECT_GT(welch_p_value(embree, bvh), 0.01) << embree.mean() << " " << bvh.mean();
}

TEST(Unit_Guiding, IsChosenWhereItPays) {
  const auto found = [](const SceneDescription& scene, RenderSettings settings) {
    settings.options.crop = PixelRect{0, 0, 4, 4};
    return rendered(scene, settings).statistics.guiding;
  };
  int chosen = 0;  // trials of few samples may be wrong
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const GuidingDone hard =
        found(rooms_with_a_gap(), guided_settings(64, 256, Guiding::Auto, seed));
    if (hard.guided_cells == 0) continue;
    ++chosen;
    EXPECT_NEAR(static_cast<double>(hard.training_samples), 0.08 * 64 * 64 * 256, 256);
  }
  EXPECT_GE(chosen, 5);
  const GuidingDone easy = found(evenly_lit(), guided_settings(64, 256, Guiding::Auto));
  EXPECT_EQ(easy.cells, 0u);
  EXPECT_NEAR(static_cast<double>(easy.training_samples), 0.02 * 64 * 64 * 256, 64);
  EXPECT_EQ(found(rooms_with_a_gap(), guided_settings(16, 64, Guiding::Auto)).training_samples, 0u)
      << "too few samples";
  EXPECT_EQ(found(rooms_with_a_gap(), guided_settings(64, 256, Guiding::Off)).training_samples, 0u);
}

// Media are not guided, nor are strategies for comparisons; and where nothing is guided the picture
// keeps its bits.
TEST(Unit_Guiding, LeavesOtherPicturesAlone) {
  SceneDescription foggy = rooms_with_a_gap();
  foggy.cameras[0].medium = add_medium(foggy, Vec3d(1), Vec3d(1));
  RenderSettings settings = guided_settings(32, 128, Guiding::On);
  settings.options.crop = PixelRect{0, 0, 4, 4};
  settings.options.max_depth = 2;
  EXPECT_EQ(rendered(foggy, settings).statistics.guiding.training_samples, 0u);
  settings.options.sampling = SamplingStrategy::Light;
  EXPECT_EQ(rendered(rooms_with_a_gap(), settings).statistics.guiding.training_samples, 0u);
  const Scene easy = compiled(evenly_lit(), settings.options);
  const auto bits = [&](Guiding guiding) {
    return picture(easy, guided_settings(64, 128, guiding)).values;
  };
  EXPECT_EQ(bits(Guiding::Auto), bits(Guiding::Off));
}

}  // namespace
}  // namespace candela
