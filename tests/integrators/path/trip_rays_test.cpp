// Rays of several blocks that are traced together, where a list of faces answers: no bit tells.
#include "integrators/path/trip_rays.h"

#include <gtest/gtest.h>

#include "renderer/accel/embree_accel.h"
#include "tests/integrators/lane_steps.h"
#include "tests/scenes/description.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

// Faces alone, and with a ball, which has a tree.
SceneDescription room(bool has_ball) {
  SceneDescription scene = small_room();
  add_light(scene, description::PointLight{{0.2, 0.6, 0.1}, Vec3d(0.3)});
  if (has_ball)
    add_mesh(scene, sphere({0.3, -0.4, 0.1}, 0.25, 3, true),
             add_material(scene, diffuse(Vec3d(0.6, 0.5, 0.4))));
  return scene;
}

TEST(Agreement_TripRays, PathsGoAsIfEachWentAlone) {
  for (const bool has_ball : {false, true}) {
    const RenderSettings settings = settings_of(30, 40);
    const Scene scene = compiled(room(has_ball), settings.options);
    const EmbreeAccel accelerator(scene, {.faces = true});
    EXPECT_GT(accelerator.face_count(), 0u);
    EXPECT_EQ(accelerator.box_count() > 0, has_ball);
    expect_single_steps(room(has_ball), settings, "path/lanes", has_ball ? "ball" : "no ball");
  }
}

TEST(Agreement_TripRays, CompanyChangesNoBit) {
  for (const bool has_ball : {false, true}) {
    const RenderSettings settings = settings_of(30, 20);
    const Scene scene = compiled(room(has_ball), settings.options);
    expect_same_bits_however_rendered(scene, settings, picture(scene, settings), {5, 3, 18, 30});
  }
}

// The same paths by Embree alone: all but those that rounding leads elsewhere.
TEST(Agreement_TripRays, ThePictureIsEmbrees) {
  RenderSettings settings = settings_of(30, 40);
  const Scene scene = compiled(room(true), settings.options);
  const std::vector<double> by_faces = grey(picture(scene, settings));
  settings.accelerator = AcceleratorKind::Embree;
  const std::vector<double> by_embree = grey(picture(scene, settings));
  std::size_t different = 0;
  for (std::size_t i = 0; i < by_faces.size(); ++i)
    different += std::abs(by_faces[i] - by_embree[i]) > 1e-3 * by_embree[i] ? 1 : 0;
  EXPECT_LT(different, by_faces.size() / 20);
}

}  // namespace
}  // namespace candela
