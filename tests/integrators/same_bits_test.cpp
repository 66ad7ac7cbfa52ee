// One scene, one set of options, one seed, one image, bit by bit, by special and general kernels.
#include <gtest/gtest.h>

#include "renderer/math/constants.h"
#include "tests/integrators/sample_ranges.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using namespace test;

TEST(Agreement_SameBits, OverThreads) {
  RenderSettings settings = settings_of(50, 20);
  settings.options.aovs = all_aovs;
  const Scene scene = compiled(small_room(), settings.options);
  settings.threads = 1;
  const Image one = picture(scene, settings);
  EXPECT_GT(mean_of(one), 0.01);
  for (const int threads : {2, 3, 7}) {
    settings.threads = threads;
    EXPECT_EQ(picture(scene, settings).values, one.values) << threads << " threads";
  }
}

TEST(Agreement_SameBits, OverTileSizes) {
  RenderSettings settings = settings_of(50, 20);
  const Scene scene = compiled(small_room(), settings.options);
  const Image sixteen = picture(scene, settings);
  for (const int size : {1, 7, 64}) {
    settings.options.tile_size = size;
    EXPECT_EQ(picture(scene, settings).values, sixteen.values) << "tiles of " << size;
  }
}

TEST(Agreement_SameBits, OverCrops) {
  RenderSettings settings = settings_of(50, 20);
  settings.options.aovs = all_aovs;
  const Scene scene = compiled(small_room(), settings.options);
  const Image whole = picture(scene, settings);
  const PixelRect crop{13, 5, 41, 50};
  settings.options.crop = crop;
  const Image part = picture(scene, settings);
  expect_part(part, whole, crop);
}

TEST(Agreement_SameBits, SpecialisedKernelIsTheGeneralOne) {
  RenderSettings settings = settings_of(48, 16);
  const Scene scene = compiled(small_room(), settings.options);
  const RenderResult special = rendered(scene, settings);
  settings.options.uses_general_kernel = true;
  const RenderResult general = rendered(scene, settings);
  EXPECT_EQ(special.statistics.kernel, "path/lanes");
  EXPECT_EQ(general.statistics.kernel, "path/general");
  EXPECT_EQ(special.film.to_image(false).values, general.film.to_image(false).values);
}

// Surfaces as lab3 has them, with a lamp, a point and a sky.
description::SceneDescription lab_room() {
  description::SceneDescription scene = small_room();
  double shininess = 0;
  for (description::Material& material : scene.materials)
    material.model = description::LabMaterial{.diffuse = {Vec3d(0.6, 0.5, 0.3), {}},
                                              .specular = {Vec3d(0.3), {}},
                                              .shininess = shininess += 20};
  scene.materials.front().model = description::LabMaterial{.diffuse = {Vec3d(0.7), {}}};
  add_light(scene, description::PointLight{{0.2, 0.3, 0.4}, Vec3d(0.2)});
  add_light(scene, description::ConstantEnvironment{Vec3d(0.1, 0.2, 0.3)});
  return scene;
}

TEST(Agreement_SameBits, LabScenesFromTheGeneralKernel) {
  RenderSettings settings = settings_of(48, 16);
  settings.options.aovs = all_aovs;
  const Scene scene = compiled(lab_room(), settings.options);
  const RenderResult special = rendered(scene, settings);
  settings.options.uses_general_kernel = true;
  const RenderResult general = rendered(scene, settings);
  EXPECT_EQ(special.statistics.kernel, "path/lanes");
  EXPECT_EQ(general.statistics.kernel, "path/general");
  EXPECT_EQ(special.film.to_image(false).values, general.film.to_image(false).values);
}

TEST(Agreement_SameBits, SeedsDiffer) {
  RenderSettings settings = settings_of(16, 4, 1);
  const Scene scene = compiled(small_room(), settings.options);
  const Image one = picture(scene, settings);
  settings.options.seed = 2;
  EXPECT_NE(picture(scene, settings).values, one.values);
}

// The first n samples of a longer render are the render of n: sums of prefixes agree.
TEST(Agreement_SameBits, SamplesArePrefixes) {
  RenderSettings settings = settings_of(16, 17);
  const Scene scene = compiled(small_room(), settings.options);
  const Image whole = picture(scene, settings);
  settings.options.samples_per_pixel = 16;
  const Image prefix = picture(scene, settings);
  double lowest = infinity;
  for (std::size_t i = 0; i < whole.pixel_count(); ++i)
    lowest = std::min(lowest, 17.0 * whole.values[4 * i] - 16.0 * prefix.values[4 * i]);
  EXPECT_GT(lowest, -1e-4);  // the seventeenth sample itself is not negative
}

// Blocks of samples that are cut anywhere: their parts give the bits of the whole.
TEST(Agreement_SameBits, OverSampleRanges) {
  RenderSettings settings = settings_of(24, 40);
  settings.options.aovs = all_aovs;
  const Scene scene = compiled(small_room(), settings.options);
  expect_same_over_cuts<general_features>(
      scene, settings, {0, 40}, {{0, 16, 32, 40}, {0, 1, 16, 17, 31, 32, 40}, {0, 5, 39, 40}});
}

// No length in the scene's unit decides anything: coordinates times a power of two give the same
// bits.
TEST(Agreement_SameBits, OverScalesByPowersOfTwo) {
  RenderSettings settings = settings_of(32, 8);
  const Image reference = picture(compiled(small_room(), settings.options), settings);
  for (const int exponent : {-40, -10, 10, 40}) {
    description::SceneDescription scaled = small_room();
    for (auto& mesh : scaled.meshes)
      for (Vec3d& p : mesh.positions) p *= std::ldexp(1.0, exponent);
    scaled.cameras[0].eye *= std::ldexp(1.0, exponent);
    EXPECT_EQ(picture(compiled(scaled, settings.options), settings).values, reference.values)
        << "2^" << exponent;
  }
}

}  // namespace
}  // namespace candela
