// A constant environment is found by the directions of BSDFs and phase functions alone.
#include <gtest/gtest.h>

#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

// A ground, a glossy ball and a cloud under the sky.
SceneDescription landscape() {
  SceneDescription scene = ball_on_ground({-0.6, 0, 0});
  add_light(scene, description::ConstantEnvironment{{0.4, 0.6, 1.0}, true});
  const auto cloud = add_medium(scene, Vec3d(0.1), Vec3d(3), 0.5);
  const auto boundary = add_material(scene, description::InterfaceMaterial{});
  scene.materials[boundary.index].media = {cloud, {}};
  add_mesh(scene, sphere({0.6, 0, 0}, 0.5, 2), boundary);
  return scene;
}

RenderSettings sky_settings(bool samples_sky, std::uint64_t seed = 1) {
  RenderSettings settings = settings_of(16, 16, seed);
  settings.options.samples_constant_sky = samples_sky;
  return settings;
}

statistics::Moments means_over_seeds(const SceneDescription& description, bool samples_sky) {
  const Scene scene = compiled(description, sky_settings(samples_sky).options);
  statistics::Moments means;
  for (std::uint64_t seed = 1; seed <= 32; ++seed)
    means.add(mean_of(picture(scene, sky_settings(samples_sky, seed))));
  return means;
}

TEST(Unit_ConstantSky, TakesNoShadowRays) {
  const auto shadow_rays = [](const RenderSettings& settings) {
    return rendered(landscape(), settings).statistics.rays.shadow;
  };
  EXPECT_EQ(shadow_rays(sky_settings(false)), 0u);
  EXPECT_GT(shadow_rays(sky_settings(true)), 0u);
}

// Strategies that do not count the light that paths meet sample it whatever is asked for.
TEST(Unit_ConstantSky, IsSampledWhereNothingElseFindsIt) {
  for (const SamplingStrategy strategy :
       {SamplingStrategy::Light, SamplingStrategy::Cosine, SamplingStrategy::Uniform}) {
    RenderOptions options = sky_settings(false).options;
    options.sampling = strategy;
    EXPECT_TRUE(compile_options(options).samples_constant_sky) << name_of(strategy);
  }
}

TEST(Statistical_ConstantSky, BothWaysGiveTheSamePicture) {
  SceneDescription with_lamps = small_room();
  add_light(with_lamps, description::ConstantEnvironment{Vec3d(0.3), true});
  for (const SceneDescription& scene : {landscape(), with_lamps}) {
    const statistics::Moments met = means_over_seeds(scene, false);
    const statistics::Moments sampled = means_over_seeds(scene, true);
    EXPECT_LT(met.standard_error() + sampled.standard_error(), 0.02 * met.mean());
    EXPECT_GT(welch_p_value(met, sampled), 0.01) << met.mean() << " " << sampled.mean();
  }
}

}  // namespace
}  // namespace candela
