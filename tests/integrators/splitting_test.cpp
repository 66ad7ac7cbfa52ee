// Splitting at the first hit: right in expectation, the same bits, less noise, and chosen where it
// pays.
#include <gtest/gtest.h>

#include "integrators/render.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

// Lamps, a sky, a mirror, glass, a lens: whatever a first hit can be.
SceneDescription room_of_kinds() {
  SceneDescription scene = small_room();
  add_mesh(scene, quad({-0.9, -0.9, 0.3}, {0.6, 0, 0.3}, {0, 0.8, 0}),
           add_material(scene, description::MirrorMaterial{}));
  add_mesh(scene, quad({0.2, -0.9, 0.5}, {0.6, 0, 0.2}, {0, 0.8, 0}),
           add_material(scene, description::DielectricMaterial{}));
  add_light(scene, description::PointLight{{0.2, 0.6, 0.1}, Vec3d(0.3)});
  add_light(scene, description::ConstantEnvironment{Vec3d(0.2), true});
  return scene;
}

// Its direct light has no noise at all, and most of its light has bounced.
SceneDescription lamp_in_a_box() {
  SceneDescription scene = furnace(inside_out(box({-1, -1, -1}, {1, 1, 1})), 0.7, 0);
  add_light(scene, description::PointLight{{0.3, 0.4, 0.2}, Vec3d(1)});
  return scene;
}

RenderSettings split_settings(int size, int samples, std::optional<int> splitting,
                              std::uint64_t seed = 1) {
  RenderSettings settings = settings_of(size, samples, seed);
  settings.options.splitting = splitting;
  return settings;
}

statistics::Moments means_over_seeds(const Scene& scene, int splitting,
                                     std::optional<int> max_depth) {
  statistics::Moments means;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    RenderSettings settings = split_settings(24, 20, splitting, seed);
    settings.options.max_depth = max_depth;
    means.add(mean_of(picture(scene, settings)));
  }
  return means;
}

TEST(Statistical_Splitting, KeepsTheMean) {
  for (const SceneDescription& description : {small_room(), room_of_kinds()})
    for (const std::optional<int> max_depth : {std::optional<int>(), std::optional(1)}) {
      const Scene scene = compiled(description, settings_of(24, 20).options);
      const statistics::Moments whole = means_over_seeds(scene, 1, max_depth);
      const statistics::Moments split = means_over_seeds(scene, 3, max_depth);
      const double error = std::hypot(whole.standard_error(), split.standard_error());
      EXPECT_LT(error, 0.02 * whole.mean());
      EXPECT_LT(std::abs(split.mean() - whole.mean()) / error, 3)
          << whole.mean() << " " << split.mean();
    }
}

// Four paths for one at a quarter of the noise, nearly: what is left is that of the first hit. And
// the error that is stated knows.
TEST(Statistical_Splitting, LowersTheErrorThatIsStated) {
  const Scene scene = compiled(small_room(), settings_of(32, 64).options);
  const auto whole = rendered(scene, split_settings(32, 64, 1));
  const auto split = rendered(scene, split_settings(32, 64, 4));
  const Image reference = picture(scene, split_settings(32, 1024, 4, 7));
  const auto relmse_of = [&](const RenderResult& result) {
    const std::vector<double> seen = grey(result.film.to_image(false)), right = grey(reference);
    double sum = 0;
    for (std::size_t i = 0; i < seen.size(); ++i)
      sum += (seen[i] - right[i]) * (seen[i] - right[i]) / (right[i] * right[i] + 1e-4);
    return sum / static_cast<double>(seen.size());
  };
  ASSERT_TRUE(whole.error && split.error);
  EXPECT_LT(split.error->relmse, 0.5 * whole.error->relmse);
  EXPECT_LT(relmse_of(split), 0.5 * relmse_of(whole));
  EXPECT_EQ(split.statistics.rays.camera, whole.statistics.rays.camera);
  EXPECT_GT(split.statistics.rays.indirect, 3 * whole.statistics.rays.indirect);
}

TEST(Agreement_Splitting, SameBitsOverThreadsTilesAndCrops) {
  for (const std::optional<int> splitting : {std::optional(4), std::optional<int>()}) {
    RenderSettings settings = split_settings(96, 84, splitting);
    settings.options.crop = PixelRect{10, 0, 34, 44};
    settings.options.aovs = aov_bit(Aov::Albedo) | aov_bit(Aov::Variance);
    const Scene scene = compiled(lamp_in_a_box(), settings.options);
    const RenderResult result = rendered(scene, settings);
    EXPECT_GT(result.statistics.splitting, 1u);
    const Image whole = result.film.to_image(true);
    settings.threads = 3;
    settings.options.tile_size = 7;
    EXPECT_EQ(picture(scene, settings).values, whole.values);
    const PixelRect crop{13, 5, 30, 40};
    settings.options.crop = crop;
    const Image part = picture(scene, settings);
    expect_part(part, whole, {crop.x0 - 10, crop.y0, crop.x1 - 10, crop.y1});  // of the first crop
  }
}

// Blocks that are cut trace their rays one by one.
TEST(Agreement_Splitting, SameBitsOverKernelsAndCutBlocks) {
  RenderSettings settings = split_settings(24, 16, 4);
  settings.options.replicates = 1;
  const Scene scene = compiled(small_room(), settings.options);
  const RenderResult special = rendered(scene, settings);
  EXPECT_EQ(special.statistics.kernel, "path/plain");
  settings.options.use_general_kernel = true;
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

std::uint32_t found_splitting(const SceneDescription& scene, RenderSettings settings) {
  settings.options.splitting.reset();
  settings.options.crop = PixelRect{0, 0, 4, 4};
  return rendered(scene, settings).statistics.splitting;
}

TEST(Unit_Splitting, IsChosenWhereItPays) {
  EXPECT_EQ(found_splitting(lamp_in_a_box(), settings_of(96, 64)), 4u) << "light that bounces";
  EXPECT_EQ(found_splitting(lamp_in_a_box(), settings_of(16, 64)), 1u) << "too small for a trial";
  RenderSettings emission_only = settings_of(96, 64);
  emission_only.options.max_depth = 0;
  EXPECT_EQ(found_splitting(lamp_in_a_box(), emission_only), 1u) << "nothing to split";
}

}  // namespace
}  // namespace candela
