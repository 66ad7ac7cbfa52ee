// Under two skies at once things are as bright as under the one and under the other, added up.
#include <gtest/gtest.h>

#include "tests/light/map_images.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using namespace test;
using description::ConstantEnvironment;
using description::EqualAreaEnvironment;
using description::ImageHandle;
using description::LatLongEnvironment;
using description::SceneDescription;

// A plane with a post on it, seen from above.
SceneDescription plane() {
  SceneDescription scene = empty_scene();
  const auto grey = add_material(scene, diffuse({0.5, 0.6, 0.7}));
  add_mesh(scene, quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}), grey);
  add_mesh(scene, quad({0, 0, -0.5}, {0, 1, 0}, {0, 0, 1}), grey);
  set_camera(scene, {0, 3, 0.01}, {0, 0, 0}, 36);
  // Suns of a few texels on gradients.
  scene.images = {
      light_test::write_float_map(
          "skies_a", 16, 16, [](int x, int y) { return Vec3f(x == 9 && y > 9 ? 30 : 1, 1, y); }),
      light_test::write_float_map("skies_b", 24, 12, [](int x, int y) {
        return Vec3f(0.1f * static_cast<float>(x), x == 5 && y == 3 ? 50 : 0, 2);
      })};
  return scene;
}

const Mat3d turned(Vec3d(0.6, 0, 0.8), Vec3d(0, 1, 0), Vec3d(-0.8, 0, 0.6));

// Means over pixels and channels by seed, of scenes with these skies.
struct Pictures {
  std::array<statistics::Moments, 3> channels;
};
template <class AddLights>
Pictures pictures(const AddLights& add_lights, std::uint64_t first_seed) {
  SceneDescription scene = plane();
  add_lights(scene);
  Pictures result;
  for (std::uint64_t seed = first_seed; seed < first_seed + 24; ++seed) {
    RenderSettings settings = settings_of(16, 16, seed);
    settings.options.max_depth = 1;
    const Image image = rendered(scene, settings).film.to_image(false);
    Vec3d sum(0.0);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        for (int c = 0; c < 3; ++c) sum[c] += double{image.pixel(x, y)[c]};
    for (int c = 0; c < 3; ++c) result.channels[static_cast<std::size_t>(c)].add(sum[c]);
  }
  return result;
}

void add_first(SceneDescription& scene) {
  add_light(scene, EqualAreaEnvironment{ImageHandle(0), Vec3d(1.5), turned, false});
}
void add_second(SceneDescription& scene) {
  add_light(scene, LatLongEnvironment{ImageHandle(1), Vec3d(1, 2, 3), Mat3d(1.0), false});
}
void add_third(SceneDescription& scene) {
  add_light(scene, ConstantEnvironment{Vec3d(0.5, 0, 2), false});
}

TEST(Statistical_SumOfSkies, LightsAPlaneAsTheSkiesDoOneByOne) {
  const Pictures first = pictures(add_first, 1);
  const Pictures second = pictures(add_second, 101);
  const Pictures third = pictures(add_third, 201);
  const Pictures all = pictures(
      [](SceneDescription& scene) {
        add_first(scene);
        add_second(scene);
        add_third(scene);
      },
      301);
  for (std::size_t c = 0; c < 3; ++c) {
    const double parts =
        first.channels[c].mean() + second.channels[c].mean() + third.channels[c].mean();
    const double variance =
        first.channels[c].variance_of_mean() + second.channels[c].variance_of_mean() +
        third.channels[c].variance_of_mean() + all.channels[c].variance_of_mean();
    const double z = (all.channels[c].mean() - parts) / std::sqrt(variance);
    EXPECT_LT(std::abs(z), 4) << c << ": " << all.channels[c].mean() << " for " << parts;
    EXPECT_LT(std::sqrt(variance), 0.01 * parts);
  }
}

}  // namespace
}  // namespace candela
