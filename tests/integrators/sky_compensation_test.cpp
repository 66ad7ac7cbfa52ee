// An environment's dim parts are left to BSDF samples [Karlik19], or not: the same picture.
#include <gtest/gtest.h>

#include "tests/light/map_images.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

// A ground and a glossy ball under a dim sky with a bright patch.
SceneDescription landscape() {
  SceneDescription scene = ball_on_ground({0, 0, 0});
  scene.images = {light_test::write_float_map("patch_in_the_sky", 16, 16, [](int x, int y) {
    return Vec3f((x - 8) * (x - 8) + (y - 8) * (y - 8) < 8 ? 4.0f : 0.5f);
  })};
  add_light(scene, description::EqualAreaEnvironment{description::ImageHandle(0), Vec3d(1.0),
                                                     Mat3d(1.0), true});
  return scene;
}

RenderSettings settings(bool compensates, std::uint64_t seed) {
  RenderSettings result = settings_of(16, 16, seed);
  result.options.compensates_sky = compensates;
  return result;
}

statistics::Moments means_over_seeds(bool compensates) {
  const Scene scene = compiled(landscape(), settings(compensates, 1).options);
  statistics::Moments means;
  for (std::uint64_t seed = 1; seed <= 64; ++seed)
    means.add(mean_of(picture(scene, settings(compensates, seed))));
  return means;
}

TEST(Statistical_SkyCompensation, LeavesThePictureAsItIs) {
  const statistics::Moments with = means_over_seeds(true);
  const statistics::Moments without = means_over_seeds(false);
  EXPECT_NE(with.mean(), without.mean());  // by other samples
  EXPECT_LT(with.standard_error() + without.standard_error(), 0.005 * with.mean());
  EXPECT_GT(welch_p_value(with, without), 0.01) << with.mean() << " " << without.mean();
}

}  // namespace
}  // namespace candela
