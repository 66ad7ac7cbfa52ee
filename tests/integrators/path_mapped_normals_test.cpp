// Normal and height maps in the path tracer: sunlight on a diffuse floor against its closed form.
#include <gtest/gtest.h>

#include "renderer/math/constants.h"
#include "tests/image/crafted_files.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

using description::SceneDescription;
using namespace test;

// A floor whose u runs along x and whose v along -z, seen straight from above its middle.
SceneDescription floor_with_map(const TemporaryFolder& folder, const crafted::Samples& texel) {
  SceneDescription scene;
  add_mesh(scene, quad({-9, 0, 9}, {18, 0, 0}, {0, 0, -18}),
           add_material(scene, diffuse(Vec3d(0.5))));
  scene.images.push_back({folder.put("map.png", crafted::png_rgba(8, 8, texel)),
                          description::Encoding::Linear,
                          description::Wrap::Repeat,
                          {}});
  set_camera(scene, {0, 6, 0}, {0, 0, 0}, 0.01, {0, 0, 1});
  return scene;
}

// Its radiance is albedo / pi times the sun's irradiance times the cosine at the mapped normal.
void expect_normal(const SceneDescription& floor, const Vec3d& normal) {
  for (const Vec3d to_sun : {Vec3d{0, 1, 0}, Vec3d{0.6, 0.8, 0}, Vec3d{-0.6, 0.8, 0},
                             Vec3d{0, 0.8, 0.6}, Vec3d{0, 0.8, -0.6}}) {
    SceneDescription scene = floor;
    add_light(scene, description::DirectionalLight{to_sun, Vec3d(3.0)});
    const double mean = mean_of(rendered(scene, settings_of(4, 4)).film.to_image(false));
    EXPECT_NEAR(mean, 0.5 / pi_double * 3 * dot(normal, to_sun), 1e-5)
        << "sun at " << to_sun.x << " " << to_sun.y << " " << to_sun.z;
  }
}

constexpr std::array<unsigned, 4> tilted{204, 179, 230, 255};

TEST(Unit_PathMappedNormals, NormalMapsTiltTheSurface) {
  const TemporaryFolder folder;
  SceneDescription scene = floor_with_map(
      folder, [](int, int, int c) { return tilted.at(static_cast<std::size_t>(c)); });
  scene.materials[0].normal_map = description::ImageHandle(0);
  const auto decoded = [](unsigned byte) { return byte / 255.0 * 2 - 1; };
  expect_normal(scene,
                normalize(Vec3d(decoded(tilted[0]), decoded(tilted[2]), -decoded(tilted[1]))));
}

TEST(Unit_PathMappedNormals, HeightMapsTiltTheSurfaceAgainstTheirSlope) {
  const TemporaryFolder folder;
  SceneDescription scene =
      floor_with_map(folder, [](int x, int, int) { return 17u * static_cast<unsigned>(x); });
  scene.materials[0].height = description::ImageHandle(0);
  scene.materials[0].height_scale = 0.5;
  constexpr double slope = 17.0 / 255 * 8;  // a ramp of 17 / 255 a texel
  expect_normal(scene, normalize(Vec3d(-0.5 * slope, 1, 0)));
}

}  // namespace
}  // namespace candela
