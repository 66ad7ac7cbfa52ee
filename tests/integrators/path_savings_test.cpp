// What makes a path cheaper changes no bit of a picture where each ray is traced by itself, as the
// reference BVH does.
#include <gtest/gtest.h>

#include "tests/image/crafted_files.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

using namespace test;

// A leaf with a round hole before a wall and, around both, a sky of one colour.
description::SceneDescription leaf_in_the_sky(const TemporaryFolder& folder) {
  description::SceneDescription scene = empty_scene();
  const std::string path = folder.put("leaf.png", crafted::png_rgba(64, 64, [](int x, int y, int) {
                                        return std::hypot(x - 32, y - 32) < 20 ? 0u : 255u;
                                      }));
  scene.images.push_back({path, Encoding::Linear, Wrap::Repeat, {}});
  const auto leaf = add_material(scene, diffuse(Vec3d(0.3, 0.6, 0.2)));
  scene.materials.back().opacity = {1, description::ImageHandle(0), description::alpha_or_first};
  add_mesh(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), leaf);
  add_mesh(scene, quad({0, 0, -0.5}, {1, 0, 0}, {0, 0.7, 0}),
           add_material(scene, diffuse(Vec3d(0.7))));
  add_light(scene, description::ConstantEnvironment{Vec3d(0.2, 0.5, 0.9)});
  set_camera(scene, {0.5, 0.5, 5}, {0.5, 0.5, 0}, 40);
  return scene;
}

RenderSettings settings_without(const PathSavings& savings) {
  RenderSettings settings = settings_of(32, 9);
  settings.accelerator = AcceleratorKind::Bvh;
  settings.options.savings = savings;
  return settings;
}

TEST(Agreement_PathSavings, ChangeNoBit) {
  const TemporaryFolder folder;
  const description::SceneDescription leaf = leaf_in_the_sky(folder);
  const RenderResult all = rendered(leaf, settings_without({}));
  const Image whole = all.film.to_image(true);
  EXPECT_GT(all.statistics.skipped.samples, 0u);
  EXPECT_GT(mean_of(whole), 0.1);
  for (const PathSavings& savings :
       {PathSavings{.skips_background = false}, PathSavings{.shares_blocks = false},
        PathSavings{.has_convoys = false}, PathSavings{.opacity_grids = false}}) {
    const RenderResult some = rendered(leaf, settings_without(savings));
    EXPECT_EQ(some.statistics.skipped.samples > 0, savings.skips_background);
    EXPECT_EQ(some.film.to_image(true).values, whole.values);
  }
}

TEST(Unit_PathSavings, WithoutOpacityGridsThereAreNone) {
  const TemporaryFolder folder;
  const description::SceneDescription leaf = leaf_in_the_sky(folder);
  EXPECT_EQ(compiled(leaf, settings_without({}).options).coverage_grids.size(), 1u);
  EXPECT_TRUE(
      compiled(leaf, settings_without({.opacity_grids = false}).options).coverage_grids.empty());
}

}  // namespace
}  // namespace candela
