// Lamps that are not there everywhere: light samples, which know nothing of holes, leave them to
// the directions that surfaces scatter in.
#include <gtest/gtest.h>

#include "tests/scenes/description.h"
#include "tests/scenes/exact_sphere.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using namespace test;

// Radiance of a floor under a lamp of this opacity, by seeds.
statistics::Moments floor_under(const description::Mesh& lamp, const Transform& place,
                                double opacity, SamplingStrategy strategy) {
  description::SceneDescription scene = empty_scene();
  add_mesh(scene, quad({-9, 0, 9}, {18, 0, 0}, {0, 0, -18}),
           add_material(scene, diffuse(Vec3d(0.5))));
  const auto material = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(10.0));
  scene.materials[material.index].opacity.factor = opacity;
  add_mesh(scene, lamp, material, place);
  set_camera(scene, {-2.5, 0.4, 0.4}, {0, 0, 0}, 0.001);
  RenderSettings settings = settings_of(4, 1024);
  settings.options.sampling = strategy;
  const Scene compiled_scene = compiled(scene, settings.options);
  statistics::Moments moments;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    settings.options.seed = seed;
    moments.add(mean_of(rendered(compiled_scene, settings).film.to_image(false)));
  }
  return moments;
}

void expect_half_the_light(const description::Mesh& lamp, const Transform& place) {
  const double whole = floor_under(lamp, place, 1, SamplingStrategy::Mis).mean();
  for (const auto strategy :
       {SamplingStrategy::Mis, SamplingStrategy::Light, SamplingStrategy::Bsdf}) {
    const statistics::Moments half = floor_under(lamp, place, 0.5, strategy);
    EXPECT_GT(half.p_value(0.5 * whole), 1e-4) << half.mean() << " of " << whole;
    EXPECT_LT(half.standard_error(), 0.02 * whole);
  }
}

TEST(Statistical_LampsWithHoles, HalfOpaqueOnesShineHalf) {
  expect_half_the_light(quad({-1, 1.5, -1}, {2, 0, 0}, {0, 0, 2}), {});
  expect_half_the_light(exact_sphere(1), at_place({0, 1.5, 0}));
}

}  // namespace
}  // namespace candela
