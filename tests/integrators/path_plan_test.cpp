// Splitting at the first hit and the threshold of Russian roulette: right in expectation, the same
// bits, less noise.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "integrators/render.h"
#include "renderer/image/compare.h"
#include "tests/integrators/leaning_mirror.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/scenes/room_of_a_point.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

// Lamps, a sky, a mirror, glass, a lens: whatever a first hit can be.
SceneDescription room_of_kinds() {
  SceneDescription scene = small_room();
  add_leaning_mirror(scene);
  add_mesh(scene, quad({0.2, -0.9, 0.5}, {0.6, 0, 0.2}, {0, 0.8, 0}),
           add_material(scene, description::DielectricMaterial{}));
  add_light(scene, description::PointLight{{0.2, 0.6, 0.1}, Vec3d(0.3)});
  add_light(scene, description::ConstantEnvironment{Vec3d(0.2), true});
  return scene;
}

RenderSettings split_settings(int size, int samples, std::uint32_t splitting,
                              std::uint64_t seed = 1) {
  RenderSettings settings = settings_of(size, samples, seed);
  settings.options.plan.splitting = splitting;
  return settings;
}

statistics::Moments means_over_seeds(const Scene& scene, const PathPlan& plan,
                                     std::optional<int> max_depth) {
  statistics::Moments means;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    RenderSettings settings = settings_of(24, 20, seed);
    settings.options.plan = plan;
    settings.options.max_depth = max_depth;
    means.add(mean_of(picture(scene, settings)));
  }
  return means;
}

TEST(Statistical_PathPlan, KeepsTheMean) {
  for (const SceneDescription& description : {small_room(), room_of_kinds()})
    for (const std::optional<int> max_depth : {std::optional<int>(), std::optional(1)}) {
      const Scene scene = compiled(description, settings_of(24, 20).options);
      const statistics::Moments plain = means_over_seeds(scene, {1, 1}, max_depth);
      for (const PathPlan& plan :
           {PathPlan{3, 1}, PathPlan{1, 0.25f}, PathPlan{2, 0.5f}, PathPlan{1, 1, 0}}) {
        const statistics::Moments planned = means_over_seeds(scene, plan, max_depth);
        const double error = std::hypot(plain.standard_error(), planned.standard_error());
        EXPECT_LT(error, 0.02 * plain.mean());
        EXPECT_LT(std::abs(planned.mean() - plain.mean()) / error, 3)
            << plain.mean() << " " << planned.mean();
      }
    }
}

struct Errors {
  double stated = 0;
  double true_relmse = 0;
};

Errors errors_over_seeds(const Scene& scene, std::uint32_t splitting, const Image& reference) {
  Errors errors;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const auto result = rendered(scene, split_settings(reference.width, 64, splitting, seed));
    errors.stated += result.error->relmse;
    errors.true_relmse += compare_images(result.film.to_image(false), reference)->relmse;
  }
  return errors;
}

// Four paths for one at a quarter of the noise, nearly: what is left is that of the first hit, and
// all in all a half, or a little more. And the error that is stated knows, though it overstates
// what the lamp's edges have in both.
TEST(Statistical_Splitting, LowersTheErrorThatIsStated) {
  const Scene scene = compiled(small_room(), settings_of(32, 64).options);
  const Image reference = rendered(scene, split_settings(32, 1024, 4, 107)).film.to_image(false);
  const Errors whole = errors_over_seeds(scene, 1, reference);
  const Errors split = errors_over_seeds(scene, 4, reference);
  EXPECT_LT(split.true_relmse, 2 / 3.0 * whole.true_relmse);
  EXPECT_LT(split.stated, 2 / 3.0 * whole.stated);
  const auto once = rendered(scene, split_settings(32, 16, 1));
  const auto often = rendered(scene, split_settings(32, 16, 4));
  EXPECT_EQ(often.statistics.rays.camera, once.statistics.rays.camera);
  EXPECT_GT(often.statistics.rays.indirect, 3 * once.statistics.rays.indirect);
}

// In a closed box each hit multiplies the throughput by the albedo, and nothing but roulette ends a
// path: the mean number of its rays is known.
TEST(Statistical_PathPlan, PathsEndWhereTheThresholdSaysSo) {
  const double albedo = 0.7;
  for (const double threshold : {1.0, 0.5, 0.2}) {
    RenderSettings settings = settings_of(32, 64);
    settings.options.plan.roulette_threshold = static_cast<float>(threshold);
    const Scene scene = compiled(room_of_a_point(albedo), settings.options);
    const RayCounts rays = rendered(scene, settings).statistics.rays;
    double expected = 0;
    double alive = 1;
    double throughput = 1;
    for (int bounce = 0; bounce < 200; ++bounce) {  // leaving the hit of this number
      throughput *= albedo;
      if (bounce >= 2) {
        const double survival = std::min(throughput / threshold, 0.998);
        alive *= survival;
        throughput /= survival;
      }
      expected += alive;
    }
    const double found = static_cast<double>(rays.indirect) / static_cast<double>(rays.camera);
    EXPECT_NEAR(found, expected, 0.01 * expected) << threshold;
  }
}

TEST(Agreement_Splitting, SameBitsOverThreadsTilesAndCrops) {
  RenderSettings settings = split_settings(96, 84, 4);
  settings.options.crop = PixelRect{10, 0, 34, 44};
  settings.options.aovs = aov_bit(Aov::Albedo) | aov_bit(Aov::Variance);
  const Scene scene = compiled(room_of_a_point(0.7), settings.options);
  const RenderResult result = rendered(scene, settings);
  expect_same_bits_however_rendered(scene, settings, result.film.to_image(true), {13, 5, 30, 40});
}

// Blocks that are cut trace their rays one by one.
TEST(Agreement_Splitting, SameBitsOverKernelsAndCutBlocks) {
  RenderSettings settings = split_settings(24, 16, 4);
  settings.options.replicates = 1;
  const Scene scene = compiled(small_room(), settings.options);
  const RenderResult special = rendered(scene, settings);
  EXPECT_EQ(special.statistics.kernel, "path/lanes");
  settings.options.uses_general_kernel = true;
  EXPECT_EQ(picture(scene, settings).values, special.film.to_image(true).values);

  settings.options.samples_per_pixel = 7;
  const Film cut = rendered(scene, settings).film;
  settings.options.samples_per_pixel = 6;
  const Film shorter = rendered(scene, settings).film;
  settings.accelerator = AcceleratorKind::Bvh;
  settings.options.samples_per_pixel = 16;
  const Film bvh = rendered(scene, settings).film;
  std::size_t different = 0;
  for (std::size_t i = 0; i < cut.pixel_count(); ++i) {
    EXPECT_TRUE(
        glm::all(glm::greaterThanEqual(cut.replicate_sum(i, 0), shorter.replicate_sum(i, 0))));
    const double own = special.film.mean(i).y;
    if (std::abs(bvh.mean(i).y - own) > 1e-3 * own) ++different;
  }
  EXPECT_LT(different, cut.pixel_count() / 50);  // hits at edges
}

// What a camera ray meets in media is a matter of chance.
TEST(Unit_Splitting, MediaAreNotSplit) {
  SceneDescription description = room_of_a_point(0.7);
  description.cameras[0].medium = add_medium(description, Vec3d(0.01), Vec3d(0.0));
  const Scene scene = compiled(description, settings_of(16, 16).options);
  const RenderResult whole = rendered(scene, split_settings(16, 16, 1));
  const RenderResult split = rendered(scene, split_settings(16, 16, 4));
  EXPECT_EQ(split.statistics.plan.splitting, 1u);
  EXPECT_EQ(split.film.to_image(true).values, whole.film.to_image(true).values);
}

}  // namespace
}  // namespace candela
