#include "integrators/ray_bench/ray_bench.h"

#include <gtest/gtest.h>

#include "integrators/ray_bench/compare_hits.h"
#include "renderer/scene/compile.h"
#include "tests/scenes/description.h"

namespace candela {
namespace {

Scene small_room() {
  Result<Scene> scene = compile(test::small_room(), {});
  EXPECT_TRUE(scene);
  return std::move(*scene);
}

const std::vector<Ray>& of(const RecordedRays& rays, RayClass kind) {
  return rays[static_cast<std::size_t>(kind)];
}

TEST(Unit_RayBench, RecordsRaysOfPaths) {
  const Scene scene = small_room();
  const EmbreeAccel embree(scene);
  const RecordedRays rays = record_rays(scene, embree, {.width = 32, .height = 32, .bounces = 2});
  EXPECT_EQ(of(rays, RayClass::Camera).size(), 32u * 32u);
  // The room is open towards the camera: some paths leave, most do not.
  EXPECT_GT(of(rays, RayClass::Bounce).size(), 32u * 32u);
  EXPECT_LE(of(rays, RayClass::Bounce).size(), 2u * 32u * 32u);
  EXPECT_GT(of(rays, RayClass::Shadow).size(), 32u * 32u);
  for (const auto& list : rays)
    for (const Ray& ray : list) EXPECT_NEAR(length(ray.direction), 1, 1e-5f);
  for (const Ray& ray : of(rays, RayClass::Shadow)) EXPECT_LT(ray.t_max, infinity);
}

// A shadow ray ends short of its light: within the room's lamp nothing is in the way but the box.
TEST(Unit_RayBench, ShadowRaysDoNotMeetTheirLight) {
  const Scene scene = small_room();
  const EmbreeAccel embree(scene);
  const RecordedRays rays = record_rays(scene, embree, {.width = 64, .height = 64});
  std::size_t blocked = 0;
  for (const Ray& ray : of(rays, RayClass::Shadow)) {
    const Hit hit = embree.intersect(ray);
    if (!hit.is_hit()) continue;
    ++blocked;
    EXPECT_FALSE(scene.geometries[hit.geometry].is_emissive());
  }
  EXPECT_LT(blocked, of(rays, RayClass::Shadow).size() / 2);
}

TEST(Unit_RayBench, NoCameraNoRays) {
  Scene scene;
  const EmbreeAccel embree(scene);
  for (const auto& list : record_rays(scene, embree, {})) EXPECT_TRUE(list.empty());
}

TEST(Unit_RayBench, FillsItsFigures) {
  const Scene scene = small_room();
  RayBenchOptions options;
  options.record.width = 32;
  options.record.height = 32;
  options.seconds_each = 0;
  const RayBenchResult result = run_ray_bench(scene, options, 2);
  EXPECT_EQ(result.threads, 2);
  EXPECT_EQ(result.triangles, 24u);
  EXPECT_EQ(result.agreement.rays,
            result.ray_counts[0] + result.ray_counts[1] + result.ray_counts[2]);
  EXPECT_EQ(result.agreement.disagreeing, 0u);
  for (const BackEndFigures& figures : {result.embree, result.bvh}) {
    EXPECT_GT(figures.build_seconds, 0);
    EXPECT_GT(figures.bytes, 0u);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_GT(figures.mrays_one_thread[i], 0);
      EXPECT_GT(figures.mrays_all_threads[i], 0);
    }
  }
  for (const Spread& ratio : result.embree_over_bvh) {
    EXPECT_GT(ratio.least, 0);
    EXPECT_LE(ratio.least, ratio.median);
    EXPECT_LE(ratio.median, ratio.most);
  }
}

TEST(Unit_Spread, IsOfTheMiddleAndTheEnds) {
  const Spread odd = spread_of({3, 1, 2});
  EXPECT_EQ(odd.median, 2);
  EXPECT_EQ(odd.least, 1);
  EXPECT_EQ(odd.most, 3);
  EXPECT_EQ(spread_of({4, 1, 2, 9}).median, 3);
  EXPECT_EQ(spread_of({}).median, 0);
}

// One triangle in the plane z = 0, seen from z = 2 through a point.
struct OneTriangle {
  Scene scene;
  Hit hit_at(float u, float v) const { return {2, u, v, 0, 0, Hit{}.instance}; }
  static Ray through(float u, float v) { return {{u, v, 2}, {0, 0, -1}, infinity}; }

  OneTriangle() {
    Geometry geometry;
    geometry.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    geometry.triangles = {{0, 1, 2}};
    geometry.material = MaterialHandle(0);
    scene.materials.emplace_back();
    scene.geometries.push_back(std::move(geometry));
    scene.world.geometries.emplace_back(0);
  }
};

TEST(Unit_CompareHits, TellsErrorsFromRounding) {
  const OneTriangle one;
  const Hit hit = one.hit_at(0.3f, 0.3f);
  const Ray ray = OneTriangle::through(0.3f, 0.3f);
  EXPECT_EQ(compare_hits(one.scene, ray, hit, hit), Agreement::Same);
  EXPECT_EQ(compare_hits(one.scene, ray, {}, {}), Agreement::Same);
  EXPECT_EQ(compare_hits(one.scene, ray, hit, {}), Agreement::Differs);
  EXPECT_EQ(compare_hits(one.scene, ray, {}, hit), Agreement::Differs);
  Hit shifted = hit;
  shifted.t = 2 + 1e-6f;
  EXPECT_EQ(compare_hits(one.scene, ray, hit, shifted), Agreement::Same);
  shifted.t = 2 + 1e-4f;
  EXPECT_EQ(compare_hits(one.scene, ray, hit, shifted), Agreement::Differs);
}

TEST(Unit_CompareHits, ExcusesEdgesAndEndsOnly) {
  const OneTriangle one;
  const Ray at_edge = OneTriangle::through(0.3f, 0);
  EXPECT_EQ(compare_hits(one.scene, at_edge, one.hit_at(0.3f, 0), {}), Agreement::AtTheEdge);
  const Ray near_edge = OneTriangle::through(0.3f, 1e-4f);
  EXPECT_EQ(compare_hits(one.scene, near_edge, one.hit_at(0.3f, 1e-4f), {}), Agreement::Differs);
  const Ray outside = OneTriangle::through(0.3f, -1e-4f);  // a hit that is none
  EXPECT_EQ(compare_hits(one.scene, outside, one.hit_at(0.3f, 0), {}), Agreement::Differs);
  Ray ends_there = OneTriangle::through(0.3f, 0.3f);
  ends_there.t_max = 2;
  EXPECT_EQ(compare_hits(one.scene, ends_there, one.hit_at(0.3f, 0.3f), {}), Agreement::AtTheEdge);
  ends_there.t_max = 2 + 1e-4f;
  EXPECT_EQ(compare_hits(one.scene, ends_there, one.hit_at(0.3f, 0.3f), {}), Agreement::Differs);
}

}  // namespace
}  // namespace candela
