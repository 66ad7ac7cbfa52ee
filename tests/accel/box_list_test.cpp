// Boxes around what is dense: no ray that meets something there passes all of them by.
#include "renderer/accel/box_list.h"

#include <gtest/gtest.h>

#include <limits>

#include "renderer/accel/bvh_accel.h"
#include "tests/accel/block_agreement.h"
#include "tests/accel/ray_sets.h"

namespace candela {
namespace {

using test::Soup;

BoxList boxes_around(const Scene& scene) {
  return {scene, scene.world.geometries};
}

// Where the ray is at t is where the triangle is at (u, v): of rays in a triangle's plane t is what
// rounding makes it.
bool is_well_met(const Scene& scene, const Ray& ray, const Hit& hit) {
  const Geometry& geometry = scene.geometries[hit.geometry];
  const auto corner = [&](std::size_t i) {
    return Vec3d(geometry.positions[geometry.triangles[hit.triangle][i]]);
  };
  const double u{hit.u}, v{hit.v};
  const Vec3d there = corner(0) * (1 - u - v) + corner(1) * u + corner(2) * v;
  const Vec3d here = Vec3d(ray.origin) + Vec3d(ray.direction) * double{hit.t};
  const double size = std::max(length(there), length(Vec3d(ray.origin)));
  return length(here - there) <= 0x1p-22 * size;
}

TEST(Unit_BoxList, WhoeverMeetsATriangleEntersABox) {
  for (const Soup& soup :
       {test::random_soup(500, 0.2f, 1), test::sliver_soup(200, 2), test::coplanar_soup(200, 3),
        test::mixed_scale_soup(200, 4), test::random_soup(1, 0.5f, 5)}) {
    const Scene scene = test::scene_of(soup);
    const BoxList boxes = boxes_around(scene);
    const BvhAccel bvh(scene);
    std::size_t hits = 0;
    for (const Ray& ray : test::rays_of_all_sets(soup, 2000)) {
      const Hit hit = bvh.intersect(ray);
      if (!hit.is_hit() || !is_well_met(scene, ray, hit)) continue;
      ++hits;
      ASSERT_TRUE(boxes.is_entered(ray));
      ASSERT_TRUE(boxes.is_entered({ray.origin, ray.direction, hit.t}));
    }
    EXPECT_GT(hits, 1000u);
  }
}

TEST(Unit_BoxList, BlocksAreToldWhatRaysAre) {
  const Soup soup = test::random_soup(300, 0.1f, 1);
  const Scene scene = test::scene_of(soup);
  const BoxList boxes = boxes_around(scene);
  std::size_t entering = 0;
  test::for_each_mixed_block(test::rays_of_all_sets(soup, 800), {all_lanes, 0b0110100110010110u},
                             [&](const RayBlock& block, LaneMask lanes) {
                               const LaneMask entered = boxes.entered(block, lanes);
                               EXPECT_EQ(entered & ~lanes, 0u);
                               for_each_lane(lanes, [&](std::uint32_t i) {
                                 ASSERT_EQ((entered >> i & 1) != 0, boxes.is_entered(block[i]));
                               });
                               entering += lane_count(entered);
                             });
  EXPECT_GT(entering, 500u);
}

// Two things far from each other leave room between.
TEST(Unit_BoxList, RaysBetweenThingsEnterNone) {
  Soup soup;
  for (const float x : {-1.0f, 1.0f})
    for (auto& triangle : test::random_soup(100, 0.1f, 1)) {
      for (Vec3f& corner : triangle) corner = 0.2f * corner + Vec3f(x, 0, 0);
      soup.push_back(triangle);
    }
  const Scene scene = test::scene_of(soup);
  const BoxList boxes = boxes_around(scene);
  EXPECT_EQ(boxes.size(), BoxList::most_boxes);
  EXPECT_FALSE(boxes.is_entered({{0, -5, 0}, {0, 1, 0}, infinity}));
  EXPECT_TRUE(boxes.is_entered({{-5, 0, 0}, {1, 0, 0}, infinity}));
  EXPECT_FALSE(boxes.is_entered({{-5, 0, 0}, {1, 0, 0}, 1.0f})) << "ends before";
  EXPECT_FALSE(boxes.is_entered({{-5, 0, 0}, {-1, 0, 0}, infinity})) << "goes away";
}

TEST(Unit_BoxList, VerticesThatCannotBeHitAreLeftOut) {
  Soup soup{{Vec3f(0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)}};
  soup.push_back({Vec3f(0, 0, 5), Vec3f(1, 0, 5), Vec3f(std::numeric_limits<float>::quiet_NaN())});
  soup.push_back({Vec3f(0, 0, 5), Vec3f(1, 0, 5), Vec3f(std::numeric_limits<float>::infinity())});
  const Scene scene = test::scene_of(soup);
  const BoxList boxes = boxes_around(scene);
  EXPECT_EQ(boxes.size(), 1u);
  EXPECT_FALSE(boxes.is_entered({{0.2f, 0.2f, 9}, {0, 0, -1}, 5}));
  EXPECT_TRUE(boxes.is_entered({{0.2f, 0.2f, 9}, {0, 0, -1}, infinity}));
  EXPECT_TRUE(BoxList(scene, {}).is_empty());
}

}  // namespace
}  // namespace candela
