// Embree and the reference BVH on whole scenes: rays of real paths and rays through everywhere.
#include <gtest/gtest.h>

#include <cstring>

#include "integrators/ray_bench/ray_bench.h"
#include "renderer/base/parallel.h"
#include "renderer/scene/compile.h"
#include "scene_io/load.h"
#include "tests/scene_io/shared_scenes.h"
#include "tests/scenes/soups.h"

namespace candela {
namespace {

constexpr std::size_t rays_a_scene = 1'000'000;

// From points of the scene's box, somewhat enlarged, in all directions.
std::vector<Ray> rays_through_everywhere(const Scene& scene, std::size_t count) {
  std::mt19937 random(1);
  std::vector<Ray> rays;
  // A flat scene has a flat box: rays must not all lie in its plane.
  const Vec3f extent = scene.bounds.extent() + Vec3f(0.2f * max_component(scene.bounds.extent()));
  while (rays.size() < count) {
    const Vec3f origin = scene.bounds.centre() + test::uniform_in_cube(random) * extent * 0.5f;
    const Ray ray{origin, normalize(test::uniform_in_cube(random)), infinity};
    if (is_traceable(ray)) rays.push_back(ray);
  }
  return rays;
}

std::vector<Hit> hits_of(const EmbreeAccel& accelerator, const std::vector<Ray>& rays) {
  std::vector<Hit> hits;
  for (const Ray& ray : rays) hits.push_back(accelerator.intersect(ray));
  return hits;
}

// Bit by bit, also of faces that lie in one place: the tree, and so the image, may not depend on
// it.
void expect_same_hits_for_any_thread_count(const Scene& scene, const std::vector<Ray>& rays) {
  std::vector<Hit> expected;
  for (const int threads : {1, 2, 3}) {
    with_threads(threads, [&] {
      const std::vector<Hit> hits = hits_of(EmbreeAccel(scene), rays);
      if (expected.empty()) expected = hits;
      EXPECT_EQ(std::memcmp(hits.data(), expected.data(), hits.size() * sizeof(Hit)), 0) << threads;
    });
  }
}

void expect_agreement(const Scene& scene) {
  const EmbreeAccel embree(scene);
  const BvhAccel bvh(scene);
  const RecordedRays recorded = record_rays(scene, embree, {.width = 256, .height = 256});
  AgreementCounts counts;
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    const bool is_shadow = static_cast<RayClass>(i) == RayClass::Shadow;
    counts += count_agreement(scene, embree, bvh, recorded[i], is_shadow);
  }
  ASSERT_GT(recorded[0].size(), 60'000u);
  ASSERT_LT(counts.rays, rays_a_scene);
  const std::vector<Ray> others =
      rays_through_everywhere(scene, (rays_a_scene - counts.rays + 1) / 2);
  counts += count_agreement(scene, embree, bvh, others, false);
  counts += count_agreement(scene, embree, bvh, others, true);
  EXPECT_GE(counts.rays, rays_a_scene);
  EXPECT_EQ(counts.disagreeing, 0u);
  EXPECT_LT(counts.at_edge, rays_a_scene / 10'000);
}

class Agreement_SharedScenes : public testing::TestWithParam<std::string> {};

TEST_P(Agreement_SharedScenes, MillionRays) {
  const std::optional<std::string> path =
      shared_scene("lab3/" + GetParam() + "/" + GetParam() + ".yaml");
  if (!path) GTEST_SKIP() << "the lab3 scenes are not here";
  const Result<description::SceneDescription> loaded = load(*path, {});
  ASSERT_TRUE(loaded);
  const Result<Scene> scene = compile(*loaded, {});
  ASSERT_TRUE(scene);
  with_threads(0, [&] { expect_agreement(*scene); });
  expect_same_hits_for_any_thread_count(*scene, rays_through_everywhere(*scene, 20'000));
}

INSTANTIATE_TEST_SUITE_P(, Agreement_SharedScenes,
                         testing::Values("cornell_box", "floor", "teapot", "bunny", "white_oak",
                                         "sibenik", "breakfast_room", "sports_car", "sponza"),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace candela
