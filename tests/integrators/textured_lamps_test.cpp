// Lamps that emit as an image says: what the camera sees of them, and that light samples and paths
// that meet them agree on it.
#include <gtest/gtest.h>

#include "integrators/path/path_step.h"
#include "integrators/ray_bench/record_rays.h"
#include "renderer/accel/embree_accel.h"
#include "renderer/description/validate.h"
#include "tests/light/directions.h"
#include "tests/light/map_images.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

// Red on the left and green on the right, twice as bright above, and a texel far brighter.
Vec3f halves(int x, int y) {
  const float bright = y < 4 ? 2.0f : 1.0f;
  if (x == 6 && y == 5) return {0, 0, 40};
  return x < 4 ? Vec3f(bright, 0, 0) : Vec3f(0, bright, 0);
}

// A lamp 2 x 1 in the plane z = 1 that shines down on a floor; `placement` moves it.
SceneDescription lamp_over_floor(const char* name, const Transform& placement = {}) {
  SceneDescription scene = empty_scene();
  scene.images.push_back(light_test::write_float_map(name, 8, 8, halves));
  scene.images.back().wrap = description::Wrap::Clamp;
  const auto lamp = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(3.0, 2.0, 1.0));
  scene.materials[lamp.index].emission_map = description::ImageHandle(std::size_t{0});
  add_mesh(scene, quad({-1, 0.5, 1}, {2, 0, 0}, {0, -1, 0}), lamp, placement);
  add_mesh(scene, quad({-3, -3, 0}, {6, 0, 0}, {0, 6, 0}),
           add_material(scene, diffuse(Vec3d(0.8))));
  set_camera(scene, {0, -2, 2}, {0, 0, 0}, 50, {0, 0, 1});
  return scene;
}

// From below: u to the right, and v down, since the camera looks up along the lamp's back.
TEST(Unit_TexturedLamps, ShowTheirImage) {
  SceneDescription scene = lamp_over_floor("lamp_seen");
  set_camera(scene, {0, 0, 0.5}, {0, 0, 1}, 20, {0, -1, 0});
  RenderSettings settings = settings_of(1, 1);
  settings.options.filter_radius = 1e-3f;
  const auto seen = [&](double x, double y) {
    scene.cameras[0].eye = {x, y, 0.5};
    scene.cameras[0].target = {x, y, 1};
    const Image image = rendered(scene, settings).film.to_image(false);
    return Rgb(image.pixel(0, 0)[0], image.pixel(0, 0)[1], image.pixel(0, 0)[2]);
  };
  // Texel centres: u = (x + 1) / 2, v = 1/2 - y, rows from v = 1 down.
  EXPECT_NEAR(seen(-0.625, -0.3125).x, 6, 1e-4);  // v = .81: the upper half
  EXPECT_NEAR(seen(-0.625, 0.3125).x, 3, 1e-4);   // v = .19
  EXPECT_NEAR(seen(0.375, 0.4375).y, 2, 1e-4);    // v = .06
  EXPECT_NEAR(seen(0.625, 0.1875).z, 40, 0.05);   // the bright texel: column 6, row 5
  EXPECT_EQ(seen(0.625, 0.1875).x, 0);
}

// What a light sample finds has the density with which a path that meets it weighs it.
TEST(Unit_TexturedLamps, AreMetWithTheDensityOfTheirSamples) {
  for (const LightSampling light_sampling : {LightSampling::Area, LightSampling::SolidAngle}) {
    RenderOptions options;
    options.light_sampling = light_sampling;
    const Scene scene = compiled(lamp_over_floor("lamp_met"), options);
    const Normalisation& n = scene.normalisation;
    SurfacePoint from = light_test::at(Vec3f((Vec3d(0.2, 0.1, 0.8) - n.centre) * n.scale));
    from.receiving_normal = {0, 0, 1};
    PathState path;
    path.receiving_normal = from.receiving_normal;
    ASSERT_EQ(scene.lights.size(), 2u);
    for (std::uint32_t lamp = 0; lamp < 2; ++lamp)
      for (std::uint64_t i = 0; i < 100; ++i) {
        const LightSample sample = sample_light(light_tables(scene), scene.lights[lamp], from,
                                                light_test::random_pair(i, 4));
        ASSERT_TRUE(sample.is_valid());
        const Ray& ray = sample.shadow_ray;
        const float distance = length(ray.origin + ray.direction - from.position);
        const float met = met_triangle_pdf(scene, lamp, from.position, path, sample.wi, distance);
        EXPECT_NEAR(met / (scene.light_sampler.probability(lamp) * sample.pdf), 1, 1e-3);
      }
  }
}

// Samples of the lamp alone, paths that meet it alone, and both together, in whole pictures.
void expect_agreement(LightSampling light_sampling) {
  const Transform mirrored{Mat3d(-1, 0, 0, 0, 1, 0, 0, 0, 1), {0.3, 0, 0}};
  for (const bool is_mirrored : {false, true}) {
    SceneDescription scene = lamp_over_floor("lamp_lights", is_mirrored ? mirrored : Transform{});
    if (is_mirrored) scene.materials[0].emits_both_sides = true;
    statistics::Moments by_light[3], by_bsdf[3];  // differences from Mis, a channel
    for (std::uint64_t seed = 1; seed <= 32; ++seed) {
      const auto means = [&](SamplingStrategy strategy, std::uint64_t stream) {
        RenderSettings settings = settings_of(12, 16, 3 * seed + stream);
        settings.options.sampling = strategy;
        settings.options.light_sampling = light_sampling;
        const Image image = rendered(scene, settings).film.to_image(false);
        Vec3d sum(0.0);
        for (int y = 0; y < image.height; ++y)
          for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c) sum[c] += double{image.pixel(x, y)[c]};
        return sum / 144.0;
      };
      const Vec3d mis = means(SamplingStrategy::Mis, 0);
      const Vec3d light = means(SamplingStrategy::Light, 1) - mis;
      const Vec3d bsdf = means(SamplingStrategy::Bsdf, 2) - mis;
      for (int c = 0; c < 3; ++c) {
        by_light[c].add(light[c]);
        by_bsdf[c].add(bsdf[c]);
        EXPECT_GT(mis[c], 0.02);
      }
    }
    for (int c = 0; c < 3; ++c) {
      EXPECT_GT(by_light[c].p_value(0), 1e-3) << is_mirrored << c << ": " << by_light[c].mean();
      EXPECT_GT(by_bsdf[c].p_value(0), 1e-3) << is_mirrored << c << ": " << by_bsdf[c].mean();
      EXPECT_LT(by_light[c].standard_error(), 0.02);
    }
  }
}

TEST(Statistical_TexturedLamps, AllStrategiesAgree) {
  expect_agreement(LightSampling::Area);
}

TEST(Statistical_TexturedLamps, AllStrategiesAgreeBySolidAngle) {
  expect_agreement(LightSampling::SolidAngle);
}

// Both triangles are picked by what their halves of the image send; a triangle whose light lies
// between the points that are looked at is picked, too.
TEST(Unit_TexturedLamps, ArePickedByTheirMeans) {
  const Scene scene = compiled(lamp_over_floor("lamp_means"), {});
  ASSERT_EQ(scene.lights.size(), 2u);
  double mean = 0;
  for (const Light& light : scene.lights) {
    EXPECT_EQ(light.kind, LightKind::TexturedTriangle);
    mean += 0.5 * static_cast<double>(light.mean_luminance);
  }
  // Red and green half each, 1.5 in the mean; the bright texel replaces a green one of 1.
  const double red = 0.2126 * 3, green = 0.7152 * 2, blue = 0.0722;
  const double expected = 0.5 * 1.5 * red + 0.5 * 1.5 * green + (40 * blue - green) / 64;
  EXPECT_NEAR(mean / expected, 1, 0.02);

  SceneDescription speck = lamp_over_floor("lamp_speck");
  speck.images[0] = light_test::write_float_map(
      "speck", 512, 512, [](int x, int y) { return Vec3f(x == 256 && y == 500 ? 1.0f : 0.0f); });
  speck.images[0].wrap = description::Wrap::Clamp;
  const Scene compiled_speck = compiled(speck, {});
  EXPECT_GT(compiled_speck.light_sampler.probability(0), 0.0f);  // the half where v < u
}

TEST(Unit_TexturedLamps, HaveShadowRaysToBeMeasured) {
  const Scene scene = compiled(lamp_over_floor("lamp_rays"), {});
  const EmbreeAccel accelerator(scene);
  const RecordedRays rays = record_rays(scene, accelerator, {.width = 16, .height = 16});
  EXPECT_GT(rays[static_cast<std::size_t>(RayClass::Shadow)].size(), 10u);
}

// White emission stands for the radiance of the mean, whatever the image's size of numbers.
TEST(Unit_TexturedLamps, CanBeGivenByTheirMean) {
  SceneDescription scene = lamp_over_floor("lamp_power");
  scene.materials[0].emission = Vec3d(5.0);
  scene.materials[0].emission_is_maps_mean = true;
  const Scene compiled_scene = compiled(scene, {});
  double mean = 0;
  for (const Light& light : compiled_scene.lights)
    mean += 0.5 * static_cast<double>(light.mean_luminance);
  EXPECT_NEAR(mean, 5, 0.1);
}

// Of an image so dark that no float holds by what it is multiplied.
TEST(Errors_TexturedLamps, TooDarkForTheirMean) {
  SceneDescription scene = lamp_over_floor("lamp_dark");
  scene.images[0] =
      light_test::write_float_map("lamp_dark", 8, 8, [](int, int) { return Vec3f(2e-38f); });
  scene.materials[0].emission = Vec3d(1000.0);
  scene.materials[0].emission_is_maps_mean = true;
  const Result<Scene> result = compile(scene, {});
  scene.materials[0].emission = Vec3d(description::largest_radiance);
  scene.materials[0].emission_is_maps_mean = false;
  EXPECT_EQ(compile(scene, {}).diagnostics.error_count(), 0u) << "the image is a factor";
  scene.materials[0].emission_map = {};
  EXPECT_EQ(compile(scene, {}).diagnostics.error_count(), 0u);
  ASSERT_EQ(result.diagnostics.error_count(), 1u);
  const std::string message = result.diagnostics.list().back().message;
  EXPECT_NE(message.find("times the mean of its image, expected at most 1e+30"), std::string::npos)
      << message;
}

}  // namespace
}  // namespace candela
