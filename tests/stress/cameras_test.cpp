// Cameras in odd places and of odd shapes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/math/constants.h"
#include "tests/scenes/description.h"
#include "tests/stress/closed_form.h"
#include "tests/stress/disturb.h"
#include "tests/stress/row.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

// Two nested boxes whose faces all emit 1 on both sides and reflect half: the radiance is 2
// everywhere, within the inner box, between the two, and on any side of the inner one's faces.
SceneDescription glowing_boxes() {
  SceneDescription scene = empty_scene();
  const auto wall = add_material(scene, diffuse(Vec3d(0.5)), Vec3d(1.0));
  scene.materials[0].emits_both_sides = true;
  add_mesh(scene, box({-1, -1, -1}, {1, 1, 1}), wall);
  add_mesh(scene, inside_out(box({-3, -3, -3}, {3, 3, 3})), wall);
  return scene;
}

struct Place {
  const char* name;
  Vec3d eye;
};

// On and next to the inner box, which has two triangles a face.
const Place places[] = {
    {"on a face", {1, 0.3, 0.1}},
    {"on a face's diagonal", {1, 0.25, 0.25}},
    {"on an edge", {1, 1, 0.2}},
    {"in a corner", {1, 1, 1}},
    {"10^-7 before a face", {0.9999999, 0.3, 0.1}},
    {"10^-7 behind a face", {1.0000001, 0.3, 0.1}},
    {"10^-12 before a corner", Vec3d(1 - 1e-12)},
};

// Into the box, out of it, and along its face.
const Vec3d looks[] = {{-1, 0.1, 0.2}, {1, 0.3, -0.2}, {0, 1, 0.4}, {0, 0, -1}};

TEST(Stress_Cameras, InsideOfSurfacesAndInCorners) {
  for (const Place& place : places)
    for (const Vec3d& look : looks)
      for (const double lens_radius : {0.0, 0.5}) {
        SceneDescription scene = glowing_boxes();
        set_camera(scene, place.eye, place.eye + look, 90, {0.1, 0.2, 1});
        scene.cameras[0].lens_radius = lens_radius;
        const std::string name =
            fmt::format("{}, towards {:.1f} {:.1f} {:.1f}{}", place.name, look.x, look.y, look.z,
                        lens_radius > 0 ? ", lens" : "");
        expect_mean(renders_of(name, scene, settings_of(8, is_heavy() ? 256 : 8), 8), 2,
                    {.resolution = 0.02, .level = 1e-6});
      }
}

// n^2 L near the middle, where nothing is reflected totally for ever. At the surface paths along it
// are, and what of them gets out has no variance (docs/accuracy_materials_lights.md): no number is
// promised there but that none is invalid.
TEST(Stress_Cameras, WithinGlass) {
  SceneDescription scene = empty_scene();
  add_mesh(scene, sphere({0, 0, 0}, 1, 4, false),
           add_material(scene, description::DielectricMaterial{}));
  add_light(scene, description::ConstantEnvironment{Vec3d(1.0), true});
  set_camera(scene, {0.2, -0.3, 0.1}, {1, 0, 0}, 90);
  const RenderSettings settings = settings_of(8, is_heavy() ? 1024 : 64);
  expect_mean(renders_of("within", scene, settings), 2.25,
              {.allowed_relative = 1e-5, .resolution = 0.01});
  set_camera(scene, scene.meshes[0].positions[7], {5, 0.3, 0.2}, 90);
  for (const Image& image : renders_of("on its surface", scene, settings, 4).images)
    EXPECT_GT(mean_of(image), 0.1);
}

// --- angles ---

// A wall at a distance of 1, wide enough for what is seen of it, turned with the camera.
SceneDescription wall_seen(double fovy_degrees, double aspect, double turn_radians) {
  const double half = std::tan(fovy_degrees * pi_double / 360) * std::max(1.0, aspect) * 2;
  SceneDescription scene = empty_scene();
  add_mesh(scene, quad({-half, -half, -1}, {2 * half, 0, 0}, {0, 2 * half, 0}),
           add_material(scene, diffuse(Vec3d(0.0)), Vec3d(1.0)));
  set_camera(scene, {0, 0, 0}, {0, 0, -1}, fovy_degrees);
  return turn_radians == 0 ? scene : rotated(scene, turn_radians, normalize(Vec3d(1, 2, 3)));
}

// The largest distance, in pixels, between where samples in the middles of pixels hit the wall and
// where the pinhole's formula puts them. Directions in float are off by their rounding, and the
// wall's points by theirs.
void expect_hits(const std::string& name, int width, int height, double fovy_degrees,
                 double turn_radians, double allowed_pixels) {
  const double aspect = static_cast<double>(width) / height;
  const SceneDescription scene = wall_seen(fovy_degrees, aspect, turn_radians);
  RenderSettings settings = settings_of(1, 1);
  settings.options.width = width;
  settings.options.height = height;
  settings.options.filter = FilterKind::Box;
  settings.options.filter_radius = 1e-6f;
  settings.options.aovs = aov_bit(Aov::Position);
  const RenderResult result = rendered(scene, settings);
  const Image image = result.film.to_image(false);
  const auto layer = static_cast<std::size_t>(std::ranges::find(image.channels, "position.X") -
                                              image.channels.begin());
  const description::Camera& camera = scene.cameras[0];
  const Vec3d look = camera.target, right = cross(look, camera.up);
  const double half = std::tan(fovy_degrees * pi_double / 360);
  double worst = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double u = (2 * (x + 0.5) / width - 1) * half * aspect;
      const double v = (1 - 2 * (y + 0.5) / height) * half;
      const Vec3d expected = look + right * u + camera.up * v;
      const float* const pixel = image.pixel(x, y);
      const Vec3d found(pixel[layer], pixel[layer + 1], pixel[layer + 2]);
      worst = std::max(worst, length(found - expected) / (2 * half / height));
    }
  EXPECT_LT(worst, allowed_pixels) << name;
  add_row(name, {{"largest error in pixels", worst},
                 {"invalid samples", static_cast<double>(result.statistics.invalid_samples)}});
}

TEST(Stress_Cameras, AnglesOfView) {
  expect_hits("60 degrees", 64, 64, 60, 0, 1e-3);
  expect_hits("60 degrees, turned", 64, 64, 60, 1, 1e-3);
  expect_hits("179 degrees", 64, 64, 179, 0, 1e-3);
  expect_hits("179 degrees, turned", 64, 64, 179, 1, 1e-2);
  expect_hits("0.01 degrees", 64, 64, 0.01, 0, 1e-3);
  // Directions are good to 6e-8 and a pixel is 2.7e-6 wide.
  expect_hits("0.01 degrees, turned", 64, 64, 0.01, 1, 0.1);
}

TEST(Stress_Cameras, OddShapes) {
  expect_hits("1x1", 1, 1, 60, 0, 1e-3);
  expect_hits("1x64", 1, 64, 60, 0, 1e-3);
  // From -89.994 to 89.994 degrees: half a turn, and a rounding of 1 is 16384 / 2 of the 24 bits.
  expect_hits("16384x1", 16384, 1, 60, 0, 0.1);
  expect_hits("1x16384", 1, 16384, 60, 0, 0.1);
}

// One pixel is the mean of the many that share its film, and a strip's crop is that part of it.
TEST(Stress_Cameras, OnePixelIsTheMeanOfMany) {
  const SceneDescription scene = small_room();
  RenderSettings many = settings_of(32, is_heavy() ? 64 : 4);
  many.options.filter = FilterKind::Box;
  RenderSettings one = many;
  one.options.width = one.options.height = 1;
  one.options.samples_per_pixel = 32 * 32 * many.options.samples_per_pixel;
  Renders means = renders_of("mean of 32x32", scene, many);
  for (Image& image : means.images) {
    const auto mean = static_cast<float>(mean_of(image));
    image.width = image.height = 1;
    image.values.assign(image.channel_count(), mean);
  }
  Renders ones = renders_of("1x1", scene, one);
  for (Image& image : ones.images) {
    const auto mean = static_cast<float>(mean_of(image));
    image.values.assign(image.channel_count(), mean);
  }
  expect_within_noise(ones, means);
}

TEST(Stress_Cameras, CropsOfAStripAreItsBits) {
  RenderSettings settings = settings_of(1, is_heavy() ? 64 : 4);
  settings.options.width = 16384;
  const Renders whole = renders_of("16384x1", small_room(), settings, 1);
  for (const int first : {0, 8160, 16320}) {
    Renders part = whole;
    Image& image = part.images[0];
    const auto channels = static_cast<std::ptrdiff_t>(image.channel_count());
    image.values = {image.values.begin() + first * channels,
                    image.values.begin() + (first + 64) * channels};
    image.width = 64;
    settings.options.crop = PixelRect{first, 0, first + 64, 1};
    expect_same_bits(renders_of(fmt::format("from {}", first), small_room(), settings, 1), part);
  }
}

}  // namespace
}  // namespace candela
