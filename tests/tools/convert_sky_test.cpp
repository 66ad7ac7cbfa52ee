// The sky that is made for pbrt is the scene's, whatever its mapping and wherever it is turned.
#include <gtest/gtest.h>

#include "renderer/image/image_io.h"
#include "renderer/sampling/warp.h"
#include "scene_io/pbrt/write/write_pbrt.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/scenes/temporary_folder.h"
#include "tools/candela/convert_images.h"

namespace candela::cli {
namespace {

using description::Encoding;
using description::ImageHandle;
using description::LatLongEnvironment;
using description::Wrap;

// A smooth latitude-longitude map with a direction of its own in each channel.
void write_map(const std::string& path) {
  Image image(256, 128, {"R", "G", "B"});
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double theta = pi_double * (y + 0.5) / image.height;
      const double phi = 2 * pi_double * (x + 0.5) / image.width;
      const Vec3d d(std::sin(theta) * std::cos(phi), std::cos(theta),
                    std::sin(theta) * std::sin(phi));
      for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = static_cast<float>(2 + d[c]);
    }
  EXPECT_FALSE(write_image(path, image, {}).has_errors());
}

TEST(Unit_ConvertSky, IsTheScenesInEveryDirection) {
  const TemporaryFolder folder;
  write_map(folder.file("map.exr"));
  description::SceneDescription scene = test::small_room();
  scene.images = {{folder.file("map.exr"), Encoding::Linear, Wrap::Repeat, {}}};
  const double s = std::sqrt(0.5);
  test::add_light(scene,
                  LatLongEnvironment{
                      ImageHandle(0), Vec3d(1, 2, 3),
                      Mat3d(s, 0, -s, 0, 1, 0, s, 0, s) * Mat3d(1, 0, 0, 0, s, s, 0, -s, s), true});
  const auto written = pbrt::write_pbrt(scene, {"files", "a.exr", 0, image_facts});
  ASSERT_EQ(written->skies.size(), 1u);
  EXPECT_EQ(written->skies[0].side, 182);  // of 32,768 texels: 181.02 squared, rounded up to even
  const auto settings = test::settings_of(8, 1);
  const Scene compiled = test::compiled(scene, settings.options);
  const auto bytes = make_sky(written->skies[0], scene);
  ASSERT_TRUE(bytes);
  ASSERT_FALSE(write_file_atomically(folder.file("sky.exr"), *bytes).has_errors());

  description::SceneDescription seen = test::small_room();
  seen.images = {{folder.file("sky.exr"), Encoding::Linear, Wrap::Clamp, {}}};
  test::add_light(seen, description::EqualAreaEnvironment{ImageHandle(0), Vec3d(1.0),
                                                          written->skies[0].world_from_sky, true});
  const Scene back = test::compiled(seen, settings.options);
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const Vec2f u(static_cast<float>(i) / 1000, static_cast<float>((i * 617) % 1000) / 1000);
    const Vec3f direction = square_to_uniform_sphere(u);
    const Rgb expected = environment_radiance(*compiled.environment, compiled.textures, direction);
    const Rgb found = environment_radiance(*back.environment, back.textures, direction);
    // Texels are .02 radians wide.
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(found[c], expected[c], 0.03 * expected[c]) << i;
  }
}

}  // namespace
}  // namespace candela::cli
