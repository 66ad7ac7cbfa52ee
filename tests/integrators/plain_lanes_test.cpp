// The plain kernel's steps of many paths at once (path/plain_lanes.h) against the general kernel's,
// one by one: the same bits and the same counts, whatever the surfaces, lamps and options.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/integrators/sample_ranges.h"
#include "tests/scenes/description.h"
#include "tests/scenes/meshes.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using namespace test;
using description::CookTorranceMaterial;
using description::MaterialHandle;
using description::SceneDescription;

CookTorranceMaterial glossy(double roughness) {
  CookTorranceMaterial material;
  material.roughness = {roughness, {}, 0};
  material.f0 = {0.9, 0.6, 0.3};
  return material;
}

// Flat and smooth surfaces, smooth ones so coarse that their normals must be bent; diffuse and
// glossy ones, and glossy ones that lanes do not know.
SceneDescription room_of_all_kinds() {
  SceneDescription scene = small_room();
  CookTorranceMaterial exact = glossy(0.2);
  exact.ior = 1.5;
  exact.fresnel = description::FresnelModel::Exact;
  CookTorranceMaterial smith = glossy(0.2);
  smith.geometry = description::GeometryModel::Smith;
  const MaterialHandle diffuse_ball = add_material(scene, diffuse({0.2, 0.5, 0.7}));
  add_mesh(scene, sphere({-0.5, 0.4, 0.2}, 0.3, 1), diffuse_ball);
  add_mesh(scene, sphere({0.5, -0.6, 0.3}, 0.35, 2), add_material(scene, glossy(0.05)));
  add_mesh(scene, box({0.3, -0.2, -0.8}, {0.8, 0.3, -0.4}), add_material(scene, glossy(0.4)));
  add_mesh(scene, sphere({0.1, 0.5, -0.4}, 0.2, 1), add_material(scene, exact));
  add_mesh(scene, box({-0.9, -1, 0.3}, {-0.6, -0.6, 0.6}), add_material(scene, smith));
  return scene;
}

// Three more lamps: a triangle, a small box and one that hangs right before the wall.
SceneDescription room_of_lamps() {
  SceneDescription scene = room_of_all_kinds();
  const auto lamp = [&](const Vec3d& emission) {
    return add_material(scene, diffuse(Vec3d(0.1)), emission);
  };
  description::Mesh triangle = quad({-0.9, 0.2, -0.5}, {0, 0.4, 0}, {0, 0, 0.4});
  triangle.triangles.resize(1);
  add_mesh(scene, triangle, lamp({1, 2, 9}));
  add_mesh(scene, box({0.6, 0.6, 0.2}, {0.7, 0.7, 0.3}), lamp({20, 5, 5}));
  add_mesh(scene, quad({-0.3, -0.3, -0.99}, {0.6, 0, 0}, {0, 0.6, 0}), lamp({2, 3, 1}));
  return scene;
}

// Thousands of lamps: they are picked by a table.
SceneDescription room_of_many_lamps() {
  SceneDescription scene = room_of_all_kinds();
  add_mesh(scene, sphere({0, 0.6, 0.6}, 0.05, 4),
           add_material(scene, diffuse(Vec3d(0)), {9, 9, 5}));
  return scene;
}

void expect_general(const SceneDescription& description, RenderSettings settings,
                    const std::string& what) {
  settings.options.aovs = all_aovs;
  const Scene scene = compiled(description, settings.options);
  const RenderResult together = rendered(scene, settings);
  settings.options.use_general_kernel = true;
  const RenderResult alone = rendered(scene, settings);
  ASSERT_EQ(together.statistics.kernel, "path/plain") << what;
  ASSERT_EQ(alone.statistics.kernel, "path/general") << what;
  EXPECT_GT(mean_of(alone.film.to_image(false)), 0.01) << what;
  EXPECT_EQ(together.film.to_image(true).values, alone.film.to_image(true).values) << what;
  EXPECT_EQ(together.statistics.rays.indirect, alone.statistics.rays.indirect) << what;
  EXPECT_EQ(together.statistics.rays.shadow, alone.statistics.rays.shadow) << what;
  EXPECT_EQ(together.statistics.skipped.shadow_rays, alone.statistics.skipped.shadow_rays) << what;
}

// Whole blocks and parts of them.
TEST(Agreement_PlainLanes, AreSingleStepsOnEverySurface) {
  for (const int samples : {64, 21, 3})
    expect_general(room_of_all_kinds(), settings_of(32, samples), fmt::format("{} spp", samples));
}

TEST(Agreement_PlainLanes, AreSingleStepsUnderEveryLamp) {
  for (const LightSampling sampling :
       {LightSampling::Triangles, LightSampling::Area, LightSampling::SolidAngle}) {
    RenderSettings settings = settings_of(32, 32);
    settings.options.light_sampling = sampling;
    const std::string what = fmt::format("sampling {}", static_cast<int>(sampling));
    expect_general(room_of_lamps(), settings, what);
    expect_general(room_of_many_lamps(), settings, what + ", many");
  }
}

TEST(Agreement_PlainLanes, AreSingleStepsOfSplitPaths) {
  for (const int splitting : {2, 5}) {
    RenderSettings settings = settings_of(32, 32);
    settings.options.splitting = splitting;
    settings.options.roulette_threshold = 0.5f;
    settings.options.lamp_rays = 3;
    expect_general(room_of_lamps(), settings, fmt::format("splitting {}", splitting));
  }
}

TEST(Agreement_PlainLanes, AreSingleStepsUpToADepth) {
  for (const int depth : {0, 1, 2, 5}) {
    for (const int splitting : {1, 3}) {
      RenderSettings settings = settings_of(24, 32);
      settings.options.max_depth = depth;
      settings.options.splitting = splitting;
      expect_general(room_of_lamps(), settings, fmt::format("depth {}, {}", depth, splitting));
    }
  }
}

TEST(Agreement_PlainLanes, NeedNoLamp) {
  SceneDescription scene = furnace(inside_out(sphere({0, 0, 0}, 1, 2)), 0.5, 0.5);
  RenderSettings settings = settings_of(8, 32);
  const Scene lit = compiled(scene, settings.options);
  for (description::Material& material : scene.materials) material.emission = Vec3d(0);
  const RenderResult dark = rendered(compiled(scene, settings.options), settings);
  EXPECT_EQ(dark.statistics.kernel, "path/plain");
  EXPECT_EQ(dark.statistics.rays.shadow, 0u);
  EXPECT_EQ(mean_of(dark.film.to_image(false)), 0);
  EXPECT_GT(mean_of(picture(lit, settings)), 0.9);
}

// Which blocks travel together depends on where passes are cut, and changes nothing.
TEST(Agreement_PlainLanes, DoNotDependOnWhoTravelsAlong) {
  RenderSettings settings = settings_of(20, 64);
  settings.options.aovs = all_aovs;
  const Scene scene = compiled(room_of_lamps(), settings.options);
  expect_same_over_cuts<plain_features>(scene, settings, {0, 64},
                                        {{0, 16, 32, 48, 64}, {0, 48, 64}, {0, 1, 17, 60, 64}});
}

}  // namespace
}  // namespace candela
