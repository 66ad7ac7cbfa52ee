// What pixels share (integrators/path/path_reuse.h) in scenes with media: between surfaces that
// bound none, seen from outside of them.
#include <gtest/gtest.h>

#include "tests/integrators/reused_paths.h"
#include "tests/scenes/description.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

// Small balls (their caustics are noise) of green glass and of glass with milk in it, and a box
// from which light goes on in smoke.
SceneDescription room_with_glass() {
  SceneDescription scene = small_room();
  const auto green = add_medium(scene, Vec3d(3, 0.5, 2), Vec3d(0), 0);
  const auto milk = add_medium(scene, Vec3d(0.1), Vec3d(3), 0.5);
  const auto smoke = add_medium(scene, Vec3d(0.3, 0.2, 0.1), Vec3d(2), 0.5);
  add_mesh(scene, sphere({-0.4, 0.2, 0.4}, 0.15, 2),
           add_material_with_media(scene, description::DielectricMaterial{}, {green, {}}));
  add_mesh(scene, sphere({0.5, -0.8, 0.5}, 0.15, 2),
           add_material_with_media(scene, description::DielectricMaterial{}, {milk, {}}));
  add_mesh(scene, box({0.3, 0.2, -0.8}, {0.8, 0.7, -0.4}),
           add_material_with_media(scene, diffuse(Vec3d(0.7)), {{}, smoke}));
  return scene;
}

SceneDescription with_interface(SceneDescription scene) {
  const auto boundary = add_material(scene, description::InterfaceMaterial{});
  scene.materials[boundary.index].media = {description::MediumHandle(scene.media.size() - 1), {}};
  add_mesh(scene, sphere({0, 0.1, 0.6}, 0.3, 2), boundary);
  return scene;
}

TEST(Statistical_ReuseMedia, KeepsTheMean) {
  expect_same_mean_shared(room_with_glass(), 256);
}

TEST(Statistical_ReuseMedia, LowersTheErrorAndTheOneThatIsStated) {
  expect_less_error_shared(room_with_glass(), 0.8);
}

// What is behind an interface may see less of a point than it seems.
TEST(Unit_ReuseMedia, IsLeftOutWhereMediaAreSeenThrough) {
  const auto is_done = [](const SceneDescription& description) {
    const RenderSettings settings = settings_with_reuse(true, 16, 16);
    return rendered(compiled(description, settings.options), settings).statistics.plan.reuses_paths;
  };
  EXPECT_TRUE(is_done(room_with_glass()));
  EXPECT_FALSE(is_done(with_interface(room_with_glass())));
  SceneDescription foggy = room_with_glass();
  foggy.cameras[0].medium = description::MediumHandle(0);
  EXPECT_FALSE(is_done(foggy));
}

TEST(Agreement_ReuseMedia, SameBitsOverThreadsTilesCropsAndKernels) {
  RenderSettings settings = settings_with_reuse(true, 40, 24);
  settings.options.replicates = 3;
  const Scene scene = compiled(room_with_glass(), settings.options);
  const RenderResult whole = expect_same_bits_shared(scene, settings);
  EXPECT_EQ(whole.statistics.kernel, "path/media_lanes");
  RenderSettings alone = settings;
  alone.options.plan.reuses_paths = false;
  EXPECT_NE(rendered(scene, alone).film.to_image(true).values, whole.film.to_image(true).values);
}

}  // namespace
}  // namespace candela
