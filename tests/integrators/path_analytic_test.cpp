// The path tracer against closed forms.
#include <gtest/gtest.h>

#include "renderer/math/constants.h"
#include "tests/scenes/description.h"
#include "tests/scenes/form_factor.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using description::SceneDescription;
using namespace test;

// Replicates by seed: the mean of an image and the standard error of that mean.
struct Estimate {
  double mean = 0;
  double standard_error = 0;
};

Estimate estimate_mean(const SceneDescription& description, RenderSettings settings,
                       int replicates = 16) {
  const Scene scene = compiled(description, settings.options);
  std::vector<double> means;
  for (int i = 0; i < replicates; ++i) {
    settings.options.seed = static_cast<std::uint64_t>(100 + i);
    means.push_back(mean_of(rendered(scene, settings).film.to_image(false)));
  }
  Estimate e;
  for (const double m : means) e.mean += m / replicates;
  double sum = 0;
  for (const double m : means) sum += square(m - e.mean);
  e.standard_error = std::sqrt(sum / (replicates - 1) / replicates);
  return e;
}

// 4.5 standard errors with 15 degrees of freedom: one false alarm in 2000 runs, and seeds are
// fixed.
void expect_mean(const SceneDescription& scene, const RenderSettings& settings, double expected) {
  const Estimate e = estimate_mean(scene, settings);
  EXPECT_NEAR(e.mean, expected, 4.5 * e.standard_error + 1e-6 * std::abs(expected))
      << "standard error " << e.standard_error;
  EXPECT_LT(e.standard_error, 0.01 * std::abs(expected)) << "the test sees too little";
}

// L = Le / (1 - rho) inside a closed box whose walls all emit Le and reflect rho.
TEST(Statistical_PathAnalytic, ClosedFurnaceBox) {
  for (const double albedo : {0.0, 0.5, 0.9}) {
    SceneDescription scene = furnace(inside_out(box({-1, -1, -1}, {1, 1, 1})), albedo, 0.25);
    set_camera(scene, {0.1, -0.2, 0.3}, {1, 0.5, 0.2}, 90);
    expect_mean(scene, settings_of(16, 64), 0.25 / (1 - albedo));
  }
}

TEST(Statistical_PathAnalytic, ClosedFurnaceSphere) {
  SceneDescription scene = furnace(sphere({5, 6, 7}, 3, 3, false), 0.6, 1.0);
  scene.materials[0].emits_both_sides = true;
  set_camera(scene, {5.5, 6, 7}, {7, 6, 7}, 90);
  expect_mean(scene, settings_of(16, 64), 1 / (1 - 0.6));
}

// Any surface of albedo 1 vanishes in a constant environment.
TEST(Statistical_PathAnalytic, WhiteObjectsVanishInAWhiteSky) {
  SceneDescription scene;
  const auto white = add_material(scene, diffuse(Vec3d(1.0)));
  add_mesh(scene, sphere({0, 0, 0}, 1, 3, true), white);
  add_mesh(scene, box({-2, -2, -2}, {-1, -1, -1}), white);
  add_light(scene, description::ConstantEnvironment{Vec3d(0.75), true});
  set_camera(scene, {0, 0, 4}, {0, 0, 0}, 40);
  RenderSettings settings = settings_of(16, 64);
  const Estimate e = estimate_mean(scene, settings);
  // Smooth normals on a polyhedron lose a little at silhouettes; they must never gain.
  EXPECT_LT(e.mean, 0.75 + 4.5 * e.standard_error);
  EXPECT_GT(e.mean, 0.74);
}

// A sphere of radius r with a point light of intensity I in its centre: irradiance I / r^2
// everywhere, and with albedo rho radiance rho/pi I/r^2 / (1 - rho).
TEST(Statistical_PathAnalytic, SphereWithALightInItsCentre) {
  SceneDescription scene;
  add_mesh(scene, sphere({0, 0, 0}, 2, 4, false), add_material(scene, diffuse(Vec3d(0.5))));
  scene.lights.push_back({{}, description::PointLight{{0, 0, 0}, Vec3d(8.0)}});
  set_camera(scene, {0, 0, 0}, {0, 0, 1}, 90);
  // The polyhedron's radius and cosine differ from the sphere's by some 1e-3 at level 4.
  const Estimate e = estimate_mean(scene, settings_of(16, 64));
  const double expected = 0.5 / pi_double * (8.0 / 4.0) / (1 - 0.5);
  EXPECT_NEAR(e.mean, expected, 4.5 * e.standard_error + 4e-3 * expected);
}

// A point light at height h over a plane, seen straight from above through a tiny angle.
TEST(Statistical_PathAnalytic, PointLightOverAPlane) {
  SceneDescription scene;
  const auto floor = add_material(scene, diffuse({0.2, 0.5, 0.8}));
  add_mesh(scene, quad({-9, 0, 9}, {18, 0, 0}, {0, 0, -18}), floor);
  scene.lights.push_back({{}, description::PointLight{{3, 4, 0}, Vec3d(50.0)}});
  set_camera(scene, {0, 6, 0}, {0, 0, 0}, 0.01, {0, 0, 1});
  const double irradiance = 50.0 / 25.0 * (4.0 / 5.0);
  const Image image = rendered(scene, settings_of(8, 4)).film.to_image(false);
  for (std::size_t c = 0; c < 3; ++c) {
    const double albedo = std::array{0.2, 0.5, 0.8}[c];
    EXPECT_NEAR(image.pixel(4, 4)[c], albedo / pi_double * irradiance, 2e-3 * irradiance * albedo);
  }
}

TEST(Statistical_PathAnalytic, SunOverAPlane) {
  SceneDescription scene;
  add_mesh(scene, quad({-9, 0, 9}, {18, 0, 0}, {0, 0, -18}),
           add_material(scene, diffuse(Vec3d(0.5))));
  scene.lights.push_back(
      {{}, description::DirectionalLight{normalize(Vec3d(1, 1, 0)), Vec3d(3.0)}});
  set_camera(scene, {0, 6, 0}, {0, 0, 0}, 30, {0, 0, 1});
  const Image image = rendered(scene, settings_of(8, 4)).film.to_image(false);
  EXPECT_NEAR(image.pixel(4, 4)[1], 0.5 / pi_double * 3 * std::sqrt(0.5), 1e-5);
}

TEST(Statistical_PathAnalytic, RectangleLightOverAPlane) {
  SceneDescription scene;
  const auto floor = add_material(scene, diffuse(Vec3d(0.5)));
  const auto lamp = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(10.0));
  add_mesh(scene, quad({-9, 0, 9}, {18, 0, 0}, {0, 0, -18}), floor);
  add_mesh(scene, quad({0, 2, 0}, {1.5, 0, 0}, {0, 0, 1}), lamp);  // shines downwards
  set_camera(scene, {-0.5, 1, -0.5}, {0, 0, 0}, 0.01);
  expect_mean(scene, settings_of(4, 256), 0.5 * 10.0 * corner_form_factor(1.5, 1, 2));
}

// Depth counts as pbrt counts: 0 sees emission only, 1 direct light, 2 one bounce more.
TEST(Statistical_PathAnalytic, DepthLimitsCutTheFurnaceSeries) {
  for (const int depth : {0, 1, 2, 5}) {
    SceneDescription scene = furnace(inside_out(box({-1, -1, -1}, {1, 1, 1})), 0.5, 1.0);
    set_camera(scene, {0, 0, 0}, {1, 0.3, 0.2}, 80);
    RenderSettings settings = settings_of(16, 64);
    settings.options.max_depth = depth;
    expect_mean(scene, settings, 2 - std::pow(0.5, depth));
  }
}

}  // namespace
}  // namespace candela
