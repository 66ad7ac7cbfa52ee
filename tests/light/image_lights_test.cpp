// Points whose intensity an image says: goniometric lights and projections.
#include <cmath>

#include <gtest/gtest.h>

#include "renderer/light/light_power.h"
#include "renderer/light/sample_light.h"
#include "renderer/math/colour.h"
#include "renderer/scene/compile.h"
#include "renderer/scene/compile_image_lights.h"
#include "tests/light/directions.h"
#include "tests/light/map_images.h"
#include "tests/scenes/description.h"

namespace candela {
namespace {

using description::GoniometricLight;
using description::ProjectionLight;
using light_test::write_float_map;

const Mat3d turned(0, 1, 0, 0, 0, 1, 1, 0, 0);  // x -> y, y -> z, z -> x

const Normalisation as_in_file;

// An image in a store of its own.
struct Picture {
  Picture(const char* name, int width, int height, const light_test::TexelFunction& texel) {
    description::Image image = write_float_map(name, width, height, texel);
    image.wrap = description::Wrap::Clamp;
    Diagnostics diagnostics;
    handle = textures.add(image, diagnostics);
  }
  TextureStore textures;
  TextureHandle handle;

  // What arrives at a distance of 1 in the direction w of the light, which is at the origin.
  [[nodiscard]] Rgb towards(const Light& light, const Vec3f& w) const {
    return sample_light({nullptr, &textures}, light, light_test::at(w), Vec2f(0)).radiance;
  }
};

Vec3f bumps(int x, int y) {
  return {1 + static_cast<float>(x), static_cast<float>(y), static_cast<float>((x * y) % 3)};
}

// The same image as a sky says what arrives where the light says what leaves.
TEST(Unit_GoniometricLight, SendsWhatASkyOfItsImageWouldShow) {
  const auto sky = light_test::equal_area(write_float_map("gonio", 8, 8, bumps), turned);
  const Picture picture("gonio_light", 8, 8, bumps);
  GoniometricLight light;
  light.intensity = Vec3d(2.0, 3.0, 4.0);
  light.world_from_map = turned;
  ImageMeans means(picture.textures);
  const Light compiled =
      goniometric_light(light, Vec3f(0), Normalisation{Vec3d(0.0), 0.5}, picture.handle, means);
  EXPECT_TRUE(compiled.is_delta());
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Vec3f w = light_test::random_direction(i, 1);
    const Rgb expected = Rgb(0.5f, 0.75f, 1) * sky.radiance(w);
    const Rgb found = picture.towards(compiled, w);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 1e-4f * (1 + expected[c]));
  }
}

// A scene 10^25 times as large has 10^50 times the intensity, which no float holds in the file's
// unit; 10^-25 times as small, the inverse.
TEST(Unit_ImageLights, HaveNoUnitOfTheirOwn) {
  const Picture picture("unit", 8, 8, bumps);
  ImageMeans means(picture.textures);
  for (const int exponent : {83, -83}) {
    GoniometricLight light;
    light.intensity = Vec3d(std::ldexp(3.0, 2 * exponent));
    ProjectionLight slide;
    slide.intensity = light.intensity;
    const Normalisation n{Vec3d(0.0), std::ldexp(1.0, -exponent)};
    const Light all_ways = goniometric_light(light, Vec3f(0), n, picture.handle, means);
    EXPECT_EQ(all_ways.emission, Rgb(3));
    EXPECT_TRUE(all_ways.mean_luminance > 0 && std::isfinite(all_ways.mean_luminance));
    const Light ahead = projection_light(slide, Vec3f(0), n, picture.handle, means);
    EXPECT_EQ(ahead.emission, Rgb(3));
    EXPECT_TRUE(ahead.mean_luminance > 0 && std::isfinite(ahead.mean_luminance));
  }
}

// pbrt refuses them.
TEST(Errors_GoniometricLight, MapsThatAreNotSquareAreNamed) {
  description::SceneDescription scene = test::small_room();
  scene.images.push_back(write_float_map("gonio_wide", 8, 4, bumps));
  GoniometricLight light;
  light.image = description::ImageHandle(scene.images.size() - 1);
  scene.lights.push_back({{}, light});
  const Result<Scene> compiled = compile(scene, {});
  ASSERT_TRUE(compiled);
  const auto& found = compiled.diagnostics.list();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].severity, Severity::Warning);
  EXPECT_NE(found[0].message.find("is 8 x 4: maps of equal areas are square"), std::string::npos);
}

double power_by_quadrature(const Picture& picture, const Light& light) {
  return light_test::integral({}, 2000, [&](const Vec3f& w) {
    return static_cast<double>(luminance(picture.towards(light, w)));
  });
}

TEST(Unit_GoniometricLight, SendsThePowerThatItIsGiven) {
  const Picture picture("gonio_power", 16, 16, bumps);
  GoniometricLight light;
  ImageMeans means(picture.textures);
  const auto compiled = [&] {
    return goniometric_light(light, Vec3f(0), as_in_file, picture.handle, means);
  };
  EXPECT_NEAR(light_power(compiled(), nullptr, 1) / power_by_quadrature(picture, compiled()), 1,
              1e-3);
  light.power = 30;
  EXPECT_NEAR(light_power(compiled(), nullptr, 1), 30, 1e-4);
  EXPECT_NEAR(power_by_quadrature(picture, compiled()), 30, 0.03);
}

TEST(Unit_GoniometricLight, WithoutAnImageIsAPoint) {
  const TextureStore none;
  GoniometricLight light;
  light.intensity = Vec3d(3.0);
  ImageMeans means(none);
  const Light compiled = goniometric_light(light, Vec3f(0), as_in_file, {}, means);
  EXPECT_EQ(sample_light({nullptr, &none}, compiled, light_test::at({0, 2, 0}), {}).radiance,
            Rgb(0.75f));
  EXPECT_NEAR(light_power(compiled, nullptr, 1), 12 * pi_double, 1e-4);
}

// Twice as wide as high, 90 degrees high: the right edge is at x = 2, the upper one at y = 1.
TEST(Unit_ProjectionLight, ShowsEachTexelInItsDirection) {
  const Picture picture("slide", 4, 2, bumps);
  ProjectionLight light;
  ImageMeans means(picture.textures);
  const Light compiled = projection_light(light, Vec3f(0), as_in_file, picture.handle, means);
  EXPECT_TRUE(compiled.is_delta());
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 2; ++y) {
      const Vec3f w = normalize(Vec3f(-1.5f + static_cast<float>(x), y == 0 ? 0.5f : -0.5f, 1));
      const Rgb found = picture.towards(compiled, w);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], bumps(x, y)[c], 1e-4f) << x << ' ' << y;
    }
  const Vec3f outside[] = {{2.001f, 0, 1}, {-2.001f, 0, 1}, {0, 1.001f, 1}, {0, 0, -1}, {1, 0, 0}};
  for (const Vec3f& w : outside) EXPECT_EQ(picture.towards(compiled, normalize(w)), Rgb(0));
  EXPECT_NE(picture.towards(compiled, normalize(Vec3f(1.999f, 0.999f, 1))), Rgb(0));
}

TEST(Unit_ProjectionLight, SendsThePowerThatItIsGiven) {
  const Picture picture("slide_power", 12, 30, bumps);
  ProjectionLight light;
  light.angle_degrees = 50;
  light.world_from_map = turned;
  ImageMeans means(picture.textures);
  const auto compiled = [&] {
    return projection_light(light, Vec3f(0), as_in_file, picture.handle, means);
  };
  EXPECT_NEAR(light_power(compiled(), nullptr, 1) / power_by_quadrature(picture, compiled()), 1,
              5e-3);
  light.power = 30;
  EXPECT_NEAR(light_power(compiled(), nullptr, 1), 30, 1e-4);
  // Another angle of the same image has a mean of its own.
  light.power.reset();
  light.angle_degrees = 80;
  EXPECT_NEAR(light_power(compiled(), nullptr, 1) / power_by_quadrature(picture, compiled()), 1,
              5e-3);
}

}  // namespace
}  // namespace candela
