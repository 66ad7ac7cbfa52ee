// Spheres that are looked at one by one: what sphere_hit.h says of all of them, to the bit.
#include "renderer/accel/sphere_list.h"

#include <gtest/gtest.h>

#include "renderer/accel/sphere_hit.h"
#include "tests/accel/block_agreement.h"
#include "tests/accel/ray_sets.h"

namespace candela {
namespace {

// In two geometries, neither of which is the scene's first.
struct Case {
  std::vector<Sphere> spheres;
  Scene scene;
  SphereList list;
};
Case case_of(std::size_t count, std::uint32_t seed) {
  Case made;
  test::RayRandom random(seed);
  made.scene.geometries.resize(3);
  for (std::size_t i = 0; i < count; ++i) {
    made.spheres.push_back(test::random_sphere(random));
    made.scene.geometries[i < count / 2 ? 1 : 2].spheres.push_back(made.spheres.back());
  }
  const std::vector<GeometryHandle> all{GeometryHandle(1), GeometryHandle(2)};
  made.list = SphereList(made.scene, all);
  return made;
}

Hit nearest_of_all(const Scene& scene, const Ray& ray) {
  Hit nearest;
  for (std::uint32_t g = 0; g < scene.geometries.size(); ++g)
    for (std::uint32_t i = 0; i < scene.geometries[g].spheres.size(); ++i) {
      const SphereHit hit = intersect_sphere(scene.geometries[g].spheres[i], ray, ray.t_max,
                                             [](float, float) { return true; });
      if (hit.t < nearest.t) nearest = {hit.t, hit.u, hit.v, g, i};
    }
  return nearest;
}

// Directions of any length, from near and far away; and from the spheres themselves.
std::vector<Ray> rays_at(const std::vector<Sphere>& spheres, std::size_t count) {
  std::vector<Ray> rays = test::sphere_rays(spheres, count, 2);
  test::RayRandom random(3);
  for (Ray& ray : rays) {
    const float scale = std::pow(10.0f, 28 * random.uniform() - 25);
    ray.direction *= scale;
    ray.t_max /= scale;
    if (random.bits() % 4 == 0) ray.origin -= ray.direction * (1000 * random.uniform() / scale);
  }
  return rays;
}

TEST(Unit_SphereList, IsOfAsManyAsABlockHasLanes) {
  EXPECT_TRUE(SphereList().is_empty());
  EXPECT_EQ(case_of(1, 1).list.size(), 1u);
  EXPECT_EQ(case_of(SphereList::most_spheres, 1).list.size(), SphereList::most_spheres);
  EXPECT_TRUE(case_of(SphereList::most_spheres + 1, 1).list.is_empty());
}

TEST(Agreement_SphereList, RaysMeetWhatTheExactTestSays) {
  for (const std::size_t count : {1u, 5u, 16u}) {
    const Case c = case_of(count, 4);
    std::size_t hits = 0;
    for (const Ray& ray : rays_at(c.spheres, 50'000)) {
      const Hit expected = nearest_of_all(c.scene, ray);
      hits += expected.is_hit();
      ASSERT_TRUE(test::are_equal(c.list.intersect(ray), expected)) << count;
      ASSERT_EQ(c.list.occluded(ray), expected.is_hit()) << count;
    }
    EXPECT_GT(hits, 5'000u);
    EXPECT_LT(hits, 45'000u);
  }
}

// In all lanes and in some, whose hits of other things stay where no sphere is met.
TEST(Agreement_SphereList, SoDoBlocks) {
  const Case c = case_of(16, 5);
  const Hit other{.t = 7, .geometry = 99};
  test::for_each_mixed_block(rays_at(c.spheres, 48'000), {all_lanes, 0b0110100110010110u},
                             [&](const RayBlock& block, LaneMask lanes) {
                               HitBlock hits;
                               for (std::uint32_t i = 0; i < block_size; ++i) hits.set(i, other);
                               c.list.intersect(block, lanes, hits);
                               const LaneMask occluded = c.list.occluded(block, lanes);
                               EXPECT_EQ(occluded & ~lanes, 0u);
                               for (std::uint32_t i = 0; i < block_size; ++i) {
                                 const Hit expected = c.list.intersect(block[i]);
                                 const bool is_met = (lanes >> i & 1) != 0 && expected.is_hit();
                                 ASSERT_TRUE(test::are_equal(hits[i], is_met ? expected : other));
                                 ASSERT_EQ((occluded >> i & 1) != 0, is_met);
                               }
                             });
}

}  // namespace
}  // namespace candela
