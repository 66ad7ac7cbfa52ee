// whitted and raster: one scene, one picture, bit by bit, in any unit.
#include "tests/integrators/whitted/lab_scenes.h"

namespace candela {
namespace {

using namespace test;

// The small room with a highlight on its box, a sheet half clear and one with a hole's alpha,
// under its lamp and a point light.
description::SceneDescription room() {
  description::SceneDescription scene = small_room();
  description::LabMaterial shiny = highlight_only(0.4, 32);
  shiny.diffuse.factor = Vec3d(0.5);
  add_mesh(scene, sphere({0.4, -0.5, 0.3}, 0.4, 3), add_material(scene, shiny));
  add_mesh(scene, quad({-0.9, -0.9, 0.7}, {1, 0, 0.1}, {0, 1, 0}), add_cutout(scene, 0.6, 0.5));
  add_mesh(scene, quad({-0.3, 0, 0.9}, {1, 0, 0.1}, {0, 0.5, 0}), add_cutout(scene, 0.6, 0.1));
  add_lab_point_light(scene, {-0.6, 0.5, 0.6}, 0.2);
  scene.lab_ambient = Vec3d(0.05);
  set_camera(scene, {0.11, 0.07, 3.5}, {0, 0, 0}, 45);  // off the axis: no sample on an edge
  return scene;
}

class Agreement_LabSameBits : public testing::TestWithParam<IntegratorKind> {
 protected:
  RenderSettings settings_ = lab_settings(GetParam(), 50, 9);
  Scene scene_ = compiled(room(), settings_.options);

  Image picture() { return rendered(scene_, settings_).film.to_image(true); }
};

TEST_P(Agreement_LabSameBits, OverThreadsTilesAndSeeds) {
  const Image reference = picture();
  EXPECT_GT(mean_of(reference), 0.01);
  for (const int threads : {1, 2, 5}) {
    settings_.threads = threads;
    settings_.options.tile_size = 3 + 5 * threads;
    settings_.options.seed = static_cast<std::uint64_t>(threads);
    EXPECT_EQ(picture().values, reference.values) << threads;
  }
}

TEST_P(Agreement_LabSameBits, OverCrops) {
  const Image whole = picture();
  const PixelRect crop{13, 5, 41, 50};
  settings_.options.crop = crop;
  const Image part = picture();
  expect_part(part, whole, crop);
}

// No length in the scene's unit decides anything.
TEST_P(Agreement_LabSameBits, OverScalesByPowersOfTwo) {
  const Image reference = picture();
  for (const int exponent : {-30, -7, 7, 30}) {
    const double scale = std::ldexp(1.0, exponent);
    description::SceneDescription scaled = room();
    for (auto& mesh : scaled.meshes)
      for (Vec3d& p : mesh.positions) p *= scale;
    scaled.cameras[0].eye *= scale;
    auto& light = std::get<description::PointLight>(scaled.lights.at(0).kind);
    light.position *= scale;
    light.intensity *= scale * scale;
    scene_ = compiled(scaled, settings_.options);
    EXPECT_EQ(picture().values, reference.values) << "2^" << exponent;
  }
}

// Up to a ray at an edge here and there: two pixels.
TEST_P(Agreement_LabSameBits, TheAcceleratorsAgree) {
  const Image embree = picture();
  settings_.accelerator = AcceleratorKind::Bvh;
  const Image bvh = picture();
  int apart = 0;
  for (std::size_t i = 0; i < embree.values.size(); ++i)
    if (std::abs(embree.values[i] - bvh.values[i]) > 1e-4f * (embree.values[i] + 0.01f)) ++apart;
  EXPECT_LE(apart, 2 * 3);
}

INSTANTIATE_TEST_SUITE_P(, Agreement_LabSameBits,
                         testing::Values(IntegratorKind::Whitted, IntegratorKind::Raster),
                         [](const auto& info) {
                           return info.param == IntegratorKind::Whitted ? "whitted" : "raster";
                         });

}  // namespace
}  // namespace candela
