// A scene's second camera gives the picture that it gives as the only one.
#include <gtest/gtest.h>

#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using namespace test;

class Unit_ChosenCamera : public testing::TestWithParam<IntegratorKind> {};

// Before a sky, whose pixels need no rays, and with a lamp's edges, which have rays of their own.
TEST_P(Unit_ChosenCamera, GivesThePictureThatItGivesAlone) {
  description::SceneDescription scene = small_room();
  if (GetParam() == IntegratorKind::Path)
    add_light(scene, description::ConstantEnvironment{Vec3d(0.2, 0.5, 0.9)});
  const description::Camera first = scene.cameras[0];
  set_camera(scene, {0.4, -0.3, 6}, {0.7, 0.5, 0}, 40);
  RenderSettings settings = settings_of(48, 16);
  settings.options.integrator = GetParam();
  settings.options.lamp_rays = 8;
  const RenderResult alone = rendered(scene, settings);
  scene.cameras.insert(scene.cameras.begin(), first);
  settings.options.camera = 1;
  const RenderResult second = rendered(scene, settings);
  EXPECT_EQ(second.film.to_image(true).values, alone.film.to_image(true).values);
  EXPECT_EQ(second.statistics.skipped.samples, alone.statistics.skipped.samples);
  if (GetParam() == IntegratorKind::Path) {
    EXPECT_GT(second.statistics.skipped.samples, 0u);
    EXPECT_GT(second.statistics.rays.lamp, 0u);
  }
  settings.options.camera = 0;
  EXPECT_NE(rendered(scene, settings).film.to_image(true).values, alone.film.to_image(true).values);
}

INSTANTIATE_TEST_SUITE_P(, Unit_ChosenCamera,
                         testing::Values(IntegratorKind::Path, IntegratorKind::Whitted,
                                         IntegratorKind::Raster, IntegratorKind::Report));

}  // namespace
}  // namespace candela
