// --light-sampling: whole pictures with lamps that are near, touch and fill the view, by triangles
// and by solid angle; the lamps being rectangles, triangles, and triangles with a texture.
#include <gtest/gtest.h>

#include "tests/integrators/replicated_pictures.h"
#include "tests/scenes/description.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

enum class Lamps { Rectangles, Triangles };

// A wide lamp close above a floor, and one that stands on it; `ball` lies between them.
template <class Model>
SceneDescription near_lamps(Model ball, Lamps lamps = Lamps::Rectangles) {
  SceneDescription scene = empty_scene();
  const auto lamp = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(3.0));
  scene.materials[lamp.index].emits_both_sides = true;
  add_mesh(scene, quad({-3, -3, 0}, {6, 0, 0}, {0, 6, 0}),
           add_material(scene, diffuse(Vec3d(0.7))));
  if (lamps == Lamps::Rectangles) {
    add_mesh(scene, quad({-1, 1, 0.8}, {2, 0, 0}, {0, -1, 0}), lamp);
    add_mesh(scene, quad({-1.2, -1, 0}, {0, 1.5, 0}, {0, 0, 1}), lamp);
  } else {
    add_mesh(scene, triangle({-1, 1, 0.8}, {1.4, 1, 0.9}, {0.3, -0.2, 0.7}), lamp);
    add_mesh(scene, triangle({-1.2, -1, 0}, {-1.2, 0.6, 0}, {-1.1, -0.4, 1.2}), lamp);
    add_mesh(scene, quad({0.6, 0, 0}, {0.5, 0.5, 0}, {0.3, 0.3, 0.5}), lamp);  // skew
  }
  add_mesh(scene, sphere({0, -0.2, 0.3}, 0.25, 2), add_material(scene, ball));
  set_camera(scene, {0.5, -2.5, 1.2}, {-0.2, 0, 0.3}, 60, {0, 0, 1});
  return scene;
}

statistics::Replicates replicates_of(const SceneDescription& description, LightSampling sampling,
                                     std::uint64_t first_seed, int max_depth = 4,
                                     SamplingStrategy strategy = SamplingStrategy::Mis) {
  RenderSettings settings = settings_of(16, 64, first_seed);
  settings.options.light_sampling = sampling;
  settings.options.max_depth = max_depth;
  settings.options.sampling = strategy;
  return replicated_pictures(description, settings,
                             "by kind " + std::to_string(static_cast<int>(sampling)));
}

void expect_agreement(const SceneDescription& scene, const char* name) {
  const auto triangles = replicates_of(scene, LightSampling::Triangles, 100);
  for (const LightSampling sampling : {LightSampling::Area, LightSampling::SolidAngle}) {
    const auto result =
        statistics::compare_replicates(replicates_of(scene, sampling, 200), triangles);
    EXPECT_TRUE(result.passed) << name << ": " << result.message;
  }
}

TEST(Agreement_LightSampling, GivesOnePictureOfDiffuseSurfaces) {
  expect_agreement(near_lamps(diffuse(Vec3d(0.5))), "diffuse");
}

TEST(Agreement_LightSampling, GivesOnePictureOfLampsThatAreTriangles) {
  expect_agreement(near_lamps(diffuse(Vec3d(0.5)), Lamps::Triangles), "triangles");
  description::DielectricMaterial rough;
  rough.roughness.factor = 0.4;
  expect_agreement(near_lamps(rough, Lamps::Triangles), "triangles, and rough glass");
}

// Light samples, BSDF samples and both, of lamps by solid angle.
TEST(Agreement_LightSampling, GivesOnePictureByEveryStrategy) {
  const SceneDescription scene = near_lamps(diffuse(Vec3d(0.5)), Lamps::Triangles);
  const auto by = [&](SamplingStrategy strategy, std::uint64_t first_seed) {
    return replicates_of(scene, LightSampling::SolidAngle, first_seed, 4, strategy);
  };
  const auto both = by(SamplingStrategy::Mis, 100);
  for (const SamplingStrategy strategy : {SamplingStrategy::Light, SamplingStrategy::Bsdf}) {
    const auto result = statistics::compare_replicates(by(strategy, 200), both);
    EXPECT_TRUE(result.passed) << static_cast<int>(strategy) << ": " << result.message;
  }
}

// Where light comes from both sides there is no warp by the cosine.
TEST(Agreement_LightSampling, GivesOnePictureThroughSurfaces) {
  description::DiffuseTransmissionMaterial leaf;
  leaf.reflectance.factor = Vec3d(0.3);
  leaf.transmittance.factor = Vec3d(0.5);
  expect_agreement(near_lamps(leaf), "a leaf");
  description::DielectricMaterial rough;
  rough.roughness.factor = 0.4;
  expect_agreement(near_lamps(rough), "rough glass");
}

TEST(Agreement_LightSampling, GivesOnePictureWithinMedia) {
  SceneDescription scene = near_lamps(diffuse(Vec3d(0.5)));
  const auto fog = add_medium(scene, Vec3d(0.05), Vec3d(0.6), 0.3);
  scene.cameras[0].medium = fog;
  expect_agreement(scene, "fog");
}

// Of direct light, in the mean over the pixels. Edges within pixels are the same noise to both.
void expect_less_noise(const SceneDescription& scene, double most) {
  const auto variances = [&](LightSampling sampling) {
    const statistics::Replicates replicates = replicates_of(scene, sampling, 300, 1);
    std::vector<double> result;
    for (std::size_t pixel = 0; pixel < replicates.images[0].size(); ++pixel) {
      statistics::Moments moments;
      for (const std::vector<double>& image : replicates.images) moments.add(image[pixel]);
      result.push_back(moments.variance());
    }
    return result;
  };
  const std::vector<double> near = variances(LightSampling::SolidAngle);
  const std::vector<double> area = variances(LightSampling::Area);
  statistics::Moments logarithms;
  for (std::size_t pixel = 0; pixel < near.size(); ++pixel)
    if (near[pixel] > 0 && area[pixel] > 0) logarithms.add(std::log(near[pixel] / area[pixel]));
  EXPECT_GT(logarithms.count(), 100u);
  EXPECT_LT(std::exp(logarithms.mean()), most);
}

TEST(Statistical_LightSampling, IsLessNoisyNearLamps) {
  expect_less_noise(near_lamps(diffuse(Vec3d(0.5))), 0.8);
}

TEST(Statistical_LightSampling, IsLessNoisyNearTriangles) {
  expect_less_noise(near_lamps(diffuse(Vec3d(0.5)), Lamps::Triangles), 0.9);
}

}  // namespace
}  // namespace candela
