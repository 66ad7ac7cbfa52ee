// Scenes with media, and the media kernel in scenes without: the same bits for any threads, crops
// and tiles, by special and general kernels, and over scales by powers of two.
#include <gtest/gtest.h>

#include "tests/integrators/lane_steps.h"
#include "tests/integrators/sample_ranges.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

// The small room with smoke in it and fog around it, in any unit.
SceneDescription smoky_room(double unit = 1) {
  SceneDescription scene = small_room();
  const auto fog = add_medium(scene, Vec3d(0.05) / unit, Vec3d(0.1, 0.15, 0.3) / unit, 0.3);
  const auto smoke = add_medium(scene, Vec3d(1, 0.5, 0.2) / unit, Vec3d(3) / unit, 0.7);
  const auto boundary = add_material(scene, description::InterfaceMaterial{});
  scene.materials[boundary.index].media = {smoke, fog};
  add_mesh(scene, sphere({0, 0, 0}, 0.5, 2), boundary);
  scene.cameras[0].medium = fog;
  for (auto& mesh : scene.meshes)
    for (Vec3d& p : mesh.positions) p *= unit;
  scene.cameras[0].eye *= unit;
  return scene;
}

std::vector<float> media_picture(const Scene& scene, const RenderSettings& settings) {
  const RenderResult result = rendered(scene, settings);
  EXPECT_EQ(result.statistics.kernel, "path/media");
  return result.film.to_image(true).values;
}

TEST(Agreement_MediaSameBits, OverThreadsTilesAndRuns) {
  RenderSettings settings = settings_of(40, 20);
  const Scene scene = compiled(smoky_room(), settings.options);
  settings.threads = 1;
  const std::vector<float> one = media_picture(scene, settings);
  settings.threads = 3;
  EXPECT_EQ(media_picture(scene, settings), one);
  settings.options.tile_size = 7;
  EXPECT_EQ(media_picture(scene, settings), one);
}

TEST(Agreement_MediaSameBits, OverScalesByPowersOfTwo) {
  const RenderSettings settings = settings_of(32, 8);
  const std::vector<float> reference =
      media_picture(compiled(smoky_room(), settings.options), settings);
  for (const int exponent : {-40, -10, 10, 40}) {
    const SceneDescription scaled = smoky_room(std::ldexp(1.0, exponent));
    EXPECT_EQ(media_picture(compiled(scaled, settings.options), settings), reference)
        << "2^" << exponent;
  }
}

// Cut within blocks, whose lanes are then traced one by one.
TEST(Agreement_MediaSameBits, OverSampleRanges) {
  const RenderSettings settings = settings_of(24, 40);
  const Scene scene = compiled(smoky_room(), settings.options);
  EXPECT_EQ(picture_of_ranges<media_features>(scene, settings, {0, 1, 16, 17, 31, 32, 40}),
            picture_of_ranges<media_features>(scene, settings, {0, 40}));
}

// Seen from outside of all media: smoke behind an interface, green glass, a diffuse surface from
// which light goes on in smoke; what stands around them, and within the smoke, bounds none.
SceneDescription room_with_media() {
  SceneDescription scene = small_room();
  const auto smoke = add_medium(scene, Vec3d(0.3, 0.2, 0.1), Vec3d(2), 0.5);
  const auto green = add_medium(scene, Vec3d(3, 0.5, 2), Vec3d(0), 0);
  add_mesh(scene, sphere({-0.4, 0.1, 0.2}, 0.4, 2),
           add_material_with_media(scene, description::InterfaceMaterial{}, {smoke, {}}));
  add_mesh(scene, box({-0.5, 0, 0.1}, {-0.3, 0.2, 0.3}), add_material(scene, diffuse(Vec3d(0.6))));
  add_mesh(scene, sphere({0.4, -0.5, 0.2}, 0.3, 3),
           add_material_with_media(scene, description::DielectricMaterial{}, {green, {}}));
  add_mesh(scene, box({0.2, 0.2, -0.6}, {0.7, 0.7, -0.2}),
           add_material_with_media(scene, diffuse(Vec3d(0.7)), {{}, smoke}));
  description::CoatedDiffuseMaterial coated;
  coated.coat.roughness = {0.2, {}, 0};
  add_mesh(scene, sphere({0.2, 0.2, 0.5}, 0.2, 2), add_material(scene, coated));
  return scene;
}

// Of triangles that shine: so many that they are picked by cells.
description::MaterialHandle many_lamps(SceneDescription& scene) {
  return add_material(scene, diffuse(Vec3d(0.0)), Vec3d(4.0));
}

// Paths take their steps side by side where they are in no medium, whatever the lights.
TEST(Agreement_MediaSameBits, LanesAreSingleSteps) {
  SceneDescription description = room_with_media();
  const auto check = [&](const std::string& what) {
    const RenderSettings settings = settings_of(32, 40);
    expect_single_steps(description, settings, "path/media_lanes", what);
    RenderOptions general = settings.options;
    general.uses_general_kernel = true;
    EXPECT_EQ(kernel_name(compiled(description, general), general), "path/media") << what;
  };
  check("a lamp");
  add_light(description, description::PointLight{{0, 0.5, 0.5}, Vec3d(0.5)});
  check("and a point");
  add_light(description, description::ConstantEnvironment{Vec3d(0.1, 0.2, 0.4), true});
  check("and a sky");
  description.lights.clear();
  add_mesh(description, sphere({0.1, -0.3, 0.4}, 0.1, 1), many_lamps(description));
  check("and many lamps");
}

TEST(Agreement_MediaSameBits, LanesDoNotDependOnWhoTravelsAlong) {
  const RenderSettings settings = settings_of(20, 64);
  SceneDescription description = room_with_media();
  const auto check = [&] {
    const Scene scene = compiled(description, settings.options);
    expect_same_over_cuts<media_lane_features>(scene, settings, {0, 64},
                                               {{0, 16, 32, 48, 64}, {0, 1, 17, 60, 64}});
  };
  check();
  add_mesh(description, sphere({0.1, -0.3, 0.4}, 0.1, 1), many_lamps(description));
  check();
}

TEST(Agreement_MediaSameBits, WithoutMediaTheKernelIsTheGeneralOne) {
  const RenderSettings settings = settings_of(32, 16);
  SceneDescription description = small_room();
  description::DielectricMaterial glass;
  add_mesh(description, sphere({0.3, -0.3, 0}, 0.3, 2), add_material(description, glass));
  add_light(description, description::PointLight{{0, 0.5, 0.5}, Vec3d(0.5)});
  add_light(description, description::ConstantEnvironment{Vec3d(0.1, 0.2, 0.4), true});
  const Scene scene = compiled(description, settings.options);
  const EmbreeAccel accelerator(scene);
  const Filter filter = make_filter(settings.options);
  const auto context = make_path_context(scene, accelerator, filter, settings.options);
  const PixelRect all{0, 0, 32, 32};
  const TilePass pass{all, {0, 16}, nullptr, settings.options.seed};
  Film general(32, 32, all, 0, 4);
  Film media(32, 32, all, 0, 4);
  const TileCounts counts = render_tile<general_features>(context, pass, general);
  const TileCounts media_counts = render_tile<media_features>(context, pass, media);
  EXPECT_EQ(media.to_image(true).values, general.to_image(true).values);
  EXPECT_EQ(media_counts.rays.shadow, counts.rays.shadow);
  EXPECT_EQ(media_counts.rays.indirect, counts.rays.indirect);
}

}  // namespace
}  // namespace candela
