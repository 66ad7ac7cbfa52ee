// Coated and thin surfaces, and interfaces, as the path tracer sees them: in a white sky a surface
// shows its albedo, whatever shares its light out among lobes.
#include <gtest/gtest.h>

#include "renderer/math/constants.h"
#include "tests/bsdf/layered_walk.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

// A wall in a sky of radiance 1, seen at the cosine from so far that the angle is one.
template <class Model>
SceneDescription wall_in_white(const Model& model, double cosine) {
  SceneDescription scene = empty_scene();
  add_mesh(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), add_material(scene, model));
  add_light(scene, description::ConstantEnvironment{Vec3d(1.0), true});
  const double sine = std::sqrt(1 - cosine * cosine);
  set_camera(scene, Vec3d(sine, 0, cosine) * 100.0, {0, 0, 0}, 0.01);
  return scene;
}

statistics::Moments pixels_of(const SceneDescription& scene) {
  RenderSettings settings = settings_of(32, 64);
  statistics::Moments moments;
  const Image image = rendered(scene, settings).film.to_image(false);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) moments.add(double{image.pixel(x, y)[1]});
  return moments;
}

double walked_albedo(const tests::LayeredSurface& surface, double cosine) {
  statistics::Moments moments;
  for (std::uint64_t i = 0; i < 400'000; ++i) {
    const tests::WalkEnd end = tests::walk_layers(surface, cosine, i);
    moments.add(end.coat + end.below);
  }
  return moments.mean();
}

void expect_albedo(const SceneDescription& scene, double expected, double allowed) {
  const statistics::Moments found = pixels_of(scene);
  EXPECT_NEAR(found.mean(), expected, allowed + 5 * found.standard_error());
  EXPECT_LT(found.standard_error(), 3e-3);
}

TEST(Statistical_SurfaceKinds, CoatedDiffuseShowsItsAlbedo) {
  for (const double alpha : {0.0, 0.2})
    for (const double cosine : {0.9, 0.3}) {
      description::CoatedDiffuseMaterial coated;
      coated.reflectance.factor = Vec3d(0.7);
      coated.coat.roughness.factor = alpha;
      SCOPED_TRACE(alpha);
      expect_albedo(wall_in_white(coated, cosine),
                    walked_albedo({.coat_alpha = alpha, .reflectance = 0.7}, cosine), 2e-3);
    }
}

TEST(Statistical_SurfaceKinds, SheetsShowBothSides) {
  description::DiffuseTransmissionMaterial sheet;
  sheet.reflectance.factor = Vec3d(0.3);
  sheet.transmittance.factor = Vec3d(0.4);
  expect_albedo(wall_in_white(sheet, 0.6), 0.7, 1e-4);
}

TEST(Unit_SurfaceKinds, InterfacesAreNotThere) {
  const statistics::Moments moments =
      pixels_of(wall_in_white(description::InterfaceMaterial{}, 0.6));
  EXPECT_EQ(moments.mean(), 1);
  EXPECT_EQ(moments.variance(), 0);
}

// A slab in a white sky, seen from above: both interfaces, all reflections between them, and what
// it takes of a crossing. In any unit of length.
TEST(Statistical_SurfaceKinds, GlassAbsorbsByTheWayWithin) {
  for (const double unit : {1.0, 1000.0}) {
    description::DielectricMaterial glass;
    const Vec3d absorption = Vec3d(0.5, 2, 0) / unit;
    SceneDescription scene = empty_scene();
    const auto material = add_material(scene, glass);
    scene.materials.back().media.inside = add_medium(scene, absorption, Vec3d(0.0));
    add_mesh(scene, box(Vec3d(-1, -1, -0.2) * unit, Vec3d(1, 1, 0.2) * unit), material);
    add_light(scene, description::ConstantEnvironment{Vec3d(1.0), true});
    set_camera(scene, Vec3d(0.3, 0.2, 100) * unit, Vec3d(0.3, 0.2, 0) * unit, 0.01);
    const Image image = rendered(scene, settings_of(16, 256)).film.to_image(false);
    for (int c = 0; c < 3; ++c) {
      statistics::Moments found;
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) found.add(double{image.pixel(x, y)[c]});
      const double f = 0.04;
      const double left = std::exp(-0.4 * absorption[c] * unit);
      const double again = square(f * left);
      const double expected = f + square(1 - f) * left * (1 + f * left) / (1 - again);
      EXPECT_NEAR(found.mean(), expected, 1e-4 + 5 * found.standard_error()) << c;
    }
  }
}

// Brushed metal, its grooves along u, seen from above under a light 20 degrees aside: along the
// grooves, or across them where they spread it.
double brushed_metal(const description::Mesh& wall, const Vec3d& aside) {
  description::ConductorMaterial metal;
  metal.roughness.factor = 0.02;
  metal.roughness_across = description::ScalarInput{0.4, {}, 0};
  SceneDescription scene = empty_scene();
  add_mesh(scene, wall, add_material(scene, metal));
  const double angle = pi_double / 9;
  add_light(scene, description::DirectionalLight{
                       Vec3d(0, 0, std::cos(angle)) + aside * std::sin(angle), Vec3d(1.0)});
  set_camera(scene, {0, 0, 100}, {0, 0, 0}, 0.01);
  return pixels_of(scene).mean();
}

TEST(Unit_SurfaceKinds, AnisotropyFollowsTheTextureCoordinates) {
  const Vec3d x(1, 0, 0), y(0, 1, 0);
  const description::Mesh u_along_x = quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  const description::Mesh u_along_y = quad({1, -1, 0}, {0, 2, 0}, {-2, 0, 0});
  const double across = brushed_metal(u_along_x, y);
  EXPECT_GT(across, 0.1);
  EXPECT_LT(brushed_metal(u_along_x, x), 1e-3 * across);
  EXPECT_NEAR(brushed_metal(u_along_y, x), across, 1e-4 * across);
  EXPECT_LT(brushed_metal(u_along_y, y), 1e-3 * across);
}

}  // namespace
}  // namespace candela
