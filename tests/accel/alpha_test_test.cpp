// Coverage decided by hashing: uniform, independent between layers, rays and what samplers make,
// the same in both accelerators.
#include "renderer/accel/alpha_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "renderer/accel/any_accel.h"
#include "renderer/sampling/sampler.h"
#include "renderer/sampling/warp.h"
#include "tests/scenes/soups.h"
#include "tests/statistics/chi_square.h"
#include "tests/statistics/distributions.h"

namespace candela {
namespace {

using test::Soup;

const double level = statistics::sidak_level(0.01, 9);  // of each of this file

// Layers that cover the view of a camera at the origin, at z = -1, -2, ...
Soup layer(int index) {
  const float z = static_cast<float>(-1 - index);
  return {{Vec3f(-50, -50, z), Vec3f(50, -50, z), Vec3f(0, 90, z)}};
}

Scene layers(int count, float opacity) {
  Scene scene = test::scene_of(Soup{});
  for (int i = 0; i < count; ++i) test::add_cutout(scene, layer(i), opacity);
  return scene;
}

// Rays as a renderer makes them: Sobol points in pixels, `samples` each.
std::vector<Ray> camera_rays(std::uint32_t pixels, std::uint32_t samples) {
  std::vector<Ray> rays;
  for (std::uint32_t y = 0; y < pixels; ++y)
    for (std::uint32_t x = 0; x < pixels; ++x)
      for (std::uint32_t i = 0; i < samples; ++i) {
        const Vec2f u = Sampler(1, x, y, i).sample_2d(0, Dimension::Filter);
        const Vec2f film = (Vec2f(float(x), float(y)) + u) / float(pixels) * 2.0f - 1.0f;
        rays.push_back({Vec3f(0), normalize(Vec3f(film, -2)), infinity});
      }
  return rays;
}

bool is_clear(const Scene& scene, std::uint32_t geometry, const Ray& ray) {
  return is_transparent_at(scene, geometry, 0, Hit{}.instance, 0.3f, 0.3f, ray.origin,
                           ray.direction);
}

// The number of standard deviations that `count` of `trials` lies off the probability.
double deviations(double count, double trials, double probability) {
  return (count - trials * probability) / std::sqrt(trials * probability * (1 - probability));
}

TEST(Statistical_AlphaTest, HitsAsOftenAsTheOpacitySays) {
  const std::vector<Ray> rays = camera_rays(128, 16);
  for (const float opacity : {0.01f, 0.25f, 0.5f, 0.9f, 0.99f}) {
    const Scene scene = layers(1, opacity);
    double hits = 0;
    for (const Ray& ray : rays) hits += !is_clear(scene, 1, ray);
    const double z =
        deviations(hits, static_cast<double>(rays.size()), static_cast<double>(opacity));
    EXPECT_GT(statistics::normal_two_sided(z), level) << opacity << ": " << z << " sigma";
  }
}

// Mirrored scenes have -0 where others have 0.
TEST(Unit_AlphaTest, BothZerosAreAlike) {
  const Scene scene = layers(1, 0.5f);
  for (Ray ray : camera_rays(16, 1)) {
    ray.direction.x = 0;
    Ray mirrored = ray;
    mirrored.origin = -ray.origin;
    mirrored.direction.x = -0.0f;
    EXPECT_EQ(is_clear(scene, 1, mirrored), is_clear(scene, 1, ray));
  }
}

// In every pixel of a picture: decisions may not hang together with where the ray goes.
TEST(Statistical_AlphaTest, PixelsAreIndependent) {
  constexpr std::uint32_t pixels = 64;
  constexpr std::uint32_t samples = 64;
  const std::vector<Ray> rays = camera_rays(pixels, samples);
  const Scene scene = layers(1, 0.5f);
  std::vector<double> histogram(samples + 1);
  for (std::size_t pixel = 0; pixel < pixels * pixels; ++pixel) {
    std::size_t hits = 0;
    for (std::size_t i = 0; i < samples; ++i)
      hits += !is_clear(scene, 1, rays[pixel * samples + i]);
    ++histogram[hits];
  }
  std::vector<double> expected(samples + 1);
  for (std::uint32_t k = 0; k <= samples; ++k)
    expected[k] = pixels * pixels *
                  std::exp(std::lgamma(samples + 1.0) - std::lgamma(k + 1.0) -
                           std::lgamma(samples - k + 1.0) - samples * std::log(2.0));
  const auto result = statistics::chi_square_test(histogram, expected);
  EXPECT_GT(result.p_value, level) << result.message;
}

// Three layers: all eight outcomes as often as independence says.
TEST(Statistical_AlphaTest, LayersAreIndependent) {
  const float opacity = 0.5f;
  const Scene scene = layers(3, opacity);
  std::array<double, 8> observed{};
  const std::vector<Ray> rays = camera_rays(256, 4);
  for (const Ray& ray : rays)
    ++observed[(is_clear(scene, 1, ray) ? 1u : 0u) + (is_clear(scene, 2, ray) ? 2u : 0u) +
               (is_clear(scene, 3, ray) ? 4u : 0u)];
  std::array<double, 8> expected;
  expected.fill(static_cast<double>(rays.size()) / 8);
  EXPECT_GT(statistics::chi_square_test(observed, expected).p_value, level);
}

// Triangles of one geometry and instances of one object are layers too.
TEST(Statistical_AlphaTest, TrianglesAndInstancesAreIndependent) {
  Scene scene = test::scene_of(Soup{});
  Soup two = layer(0);
  two.push_back(layer(1)[0]);
  test::add_cutout(scene, two, 0.5f);
  std::array<double, 8> observed{};
  const std::vector<Ray> rays = camera_rays(256, 4);
  const auto decision = [&](const Ray& ray, std::uint32_t triangle, std::uint32_t instance) {
    return is_transparent_at(scene, 1, triangle, instance, 0.3f, 0.3f, ray.origin, ray.direction);
  };
  for (const Ray& ray : rays)
    ++observed[(decision(ray, 0, 0) ? 1u : 0u) + (decision(ray, 1, 0) ? 2u : 0u) +
               (decision(ray, 0, 1) ? 4u : 0u)];
  std::array<double, 8> expected;
  expected.fill(static_cast<double>(rays.size()) / 8);
  EXPECT_GT(statistics::chi_square_test(observed, expected).p_value, level);
}

// A path's bounce direction must not tell what the cut-out decides: the mean of each sampled
// dimension over the rays that pass equals that over those that are stopped.
TEST(Statistical_AlphaTest, IndependentOfTheSampler) {
  const Scene scene = layers(1, 0.5f);
  double sum[2] = {0, 0};
  double count[2] = {0, 0};
  for (std::uint32_t i = 0; i < 1u << 18; ++i) {
    const Sampler sampler(7, i & 0xff, (i >> 8) & 0xff, i >> 16);
    const Vec2f u = sampler.sample_2d(1, Dimension::Direction);
    const Ray ray{Vec3f(0.25f, 0.5f, 0), square_to_cosine_hemisphere(u), infinity};
    const int side = is_clear(scene, 1, ray) ? 1 : 0;
    sum[side] += static_cast<double>(u.x);
    ++count[side];
  }
  const double difference = sum[0] / count[0] - sum[1] / count[1];
  const double sigma = std::sqrt((1 / count[0] + 1 / count[1]) / 12);
  EXPECT_GT(statistics::normal_two_sided(difference / sigma), level);
}

TEST(Unit_AlphaTest, WhollyOpaqueAndWhollyClear) {
  const std::vector<Ray> rays = camera_rays(16, 4);
  const Scene opaque = layers(1, 1);
  const Scene clear = layers(1, 0);
  for (const Ray& ray : rays) {
    EXPECT_FALSE(is_clear(opaque, 1, ray));
    EXPECT_TRUE(is_clear(clear, 1, ray));
  }
}

TEST(Unit_AlphaTest, ThresholdsOfLabMaterials) {
  const std::vector<Ray> rays = camera_rays(32, 4);
  const auto hits = [&](float opacity, bool is_lab) {
    Scene scene = layers(1, opacity);
    scene.materials.back().lab_opacity = is_lab;
    return std::ranges::count_if(rays, [&](const Ray& ray) { return !is_clear(scene, 1, ray); });
  };
  const auto all = std::ssize(rays);
  EXPECT_EQ(hits(0.19f, true), 0);
  EXPECT_EQ(hits(0.2f, true), hits(0.2f, false));
  EXPECT_EQ(hits(0.89f, true), hits(0.89f, false));
  EXPECT_EQ(hits(0.9f, true), all);
  EXPECT_TRUE(hits(0.19f, false) > 0 && hits(0.95f, false) < all);
  EXPECT_EQ(hits(1.5f, false), all);
  EXPECT_EQ(hits(-0.5f, false), 0);
}

// The first layer that stops the ray is the one that is hit, in every order of traversal.
template <Accelerator A>
void expect_first_stopping_layer(const Scene& scene, int layer_count) {
  const A accelerator(scene);
  for (const Ray& ray : camera_rays(64, 4)) {
    int first = 0;
    while (first < layer_count && is_clear(scene, static_cast<std::uint32_t>(first + 1), ray))
      ++first;
    const Hit hit = accelerator.intersect(ray);
    ASSERT_EQ(hit.is_hit(), first < layer_count);
    ASSERT_EQ(accelerator.occluded(ray), first < layer_count);
    if (hit.is_hit()) {
      ASSERT_EQ(hit.geometry, static_cast<std::uint32_t>(first + 1));
    }
  }
}

TEST(Unit_AlphaTest, BothAcceleratorsStopAtTheSameLayer) {
  const Scene scene = layers(6, 0.4f);
  expect_first_stopping_layer<BvhAccel>(scene, 6);
  expect_first_stopping_layer<EmbreeAccel>(scene, 6);
}

// Spatial splits call a filter several times for one triangle: its answer may not change.
TEST(Unit_AlphaTest, AcceleratorsAgreeOnCutoutsInInstances) {
  const Scene scene = test::scene_of_all_kinds();
  const BvhAccel bvh(scene);
  const EmbreeAccel embree(scene);
  std::mt19937 random(44);
  int instanced = 0;
  int differing = 0;
  for (int i = 0; i < 50000; ++i) {
    const Vec3f origin = test::uniform_in_cube(random) * 3.0f;
    const Ray ray{origin, normalize(test::uniform_in_cube(random) - origin), infinity};
    const Hit a = embree.intersect(ray);
    const Hit b = bvh.intersect(ray);
    instanced += b.is_instanced();
    differing += a.geometry != b.geometry || a.triangle != b.triangle || a.instance != b.instance;
    EXPECT_EQ(a.is_hit(), embree.occluded(ray));
    EXPECT_EQ(b.is_hit(), bvh.occluded(ray));
  }
  EXPECT_GT(instanced, 5000);
  EXPECT_LE(differing, 2);  // at edges
}

}  // namespace
}  // namespace candela
