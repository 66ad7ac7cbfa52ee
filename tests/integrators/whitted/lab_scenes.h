// Small scenes for lab3's own shading, seen through one ray: closed forms to the float.
#pragma once

#include <gtest/gtest.h>

#include "renderer/math/constants.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"

namespace candela::test {

[[nodiscard]] inline RenderSettings lab_settings(IntegratorKind integrator, int size = 1,
                                                 int samples_per_pixel = 1) {
  RenderSettings settings = settings_of(size, samples_per_pixel);
  settings.options.integrator = integrator;
  return settings;
}

// The radiance along the camera's axis: one pixel, one sample in its centre.
[[nodiscard]] inline Rgb seen(const description::SceneDescription& scene,
                              const RenderSettings& settings) {
  const Image image = rendered(scene, settings).film.to_image(false);
  return {image.values[0], image.values[1], image.values[2]};
}
[[nodiscard]] inline Rgb seen_by_whitted(const description::SceneDescription& scene,
                                         int max_depth = 5) {
  RenderSettings settings = lab_settings(IntegratorKind::Whitted);
  settings.options.max_depth = max_depth;
  return seen(scene, settings);
}

// A horizontal square sheet at height y, facing up; no edge or diagonal near the y axis.
inline void add_sheet(description::SceneDescription& scene, double y,
                      description::MaterialHandle material) {
  add_mesh(scene, quad({-9, y, 8}, {20, 0, 0}, {0, 0, -18}), material);
}

// A floor at y = 0, seen from (0, eye, 0) straight down at the origin.
[[nodiscard]] inline description::SceneDescription floor_seen_from(
    double eye, const description::DiffuseMaterial& floor) {
  description::SceneDescription scene = empty_scene();
  add_sheet(scene, 0, add_material(scene, floor));
  set_camera(scene, {0, eye, 0}, {0, 0, 0}, 40, {0, 0, 1});
  return scene;
}

// Of lab3's Intensity: what the reader makes of it (docs/scene_format.md).
inline void add_lab_point_light(description::SceneDescription& scene, const Vec3d& position,
                                double intensity) {
  add_light(scene, description::PointLight{position, Vec3d(pi_double * intensity)});
}

[[nodiscard]] inline description::MaterialHandle add_cutout(description::SceneDescription& scene,
                                                            double reflectance, double opacity) {
  const auto handle = add_material(scene, diffuse(Vec3d(reflectance)));
  scene.materials[handle.index].opacity.factor = opacity;
  return handle;
}

// Black but for its highlight; ks a multiple of 1/255, the exponent of 256/255.
[[nodiscard]] inline description::LabMaterial highlight_only(double ks, double exponent) {
  description::LabMaterial material;
  material.diffuse.factor = Vec3d(0.0);
  material.specular.factor = Vec3d(ks);
  material.shininess = exponent;
  return material;
}

inline void expect_near(const Rgb& value, const Vec3d& expected, double relative = 1e-5) {
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(value[c], expected[c], relative * std::abs(expected[c])) << "channel " << c;
}

}  // namespace candela::test
