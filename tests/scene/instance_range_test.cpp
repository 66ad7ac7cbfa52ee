#include "renderer/scene/instance_range.h"

#include <gtest/gtest.h>

#include "tests/scenes/soups.h"

namespace candela {
namespace {

const Bounds3f unit_box = [] {
  Bounds3f box;
  box.include(Vec3f(-1));
  box.include(Vec3f(1));
  return box;
}();

Instance scaled(float factor, const Vec3f& translation = Vec3f(0)) {
  return test::placement({factor, 0, 0}, {0, factor, 0}, {0, 0, factor}, translation);
}

TEST(Unit_InstanceRange, WhatFloatsCannotHoldIsNotPlaceable) {
  EXPECT_TRUE(is_placeable(scaled(1), unit_box));
  EXPECT_TRUE(is_placeable(scaled(1e-6f), unit_box));
  EXPECT_FALSE(is_placeable(scaled(1e20f), unit_box));
  EXPECT_FALSE(is_placeable(scaled(1, Vec3f(1e19f, 0, 0)), unit_box));
  EXPECT_FALSE(is_placeable(scaled(0), unit_box)) << "it has no inverse";
  EXPECT_TRUE(is_placeable(scaled(0), Bounds3f())) << "but nothing is placed";
}

TEST(Unit_InstanceRange, LargeGroundsHaveFewTriangles) {
  EXPECT_TRUE(is_large_ground(scaled(1e5f), unit_box, 2));
  EXPECT_FALSE(is_large_ground(scaled(1e5f), unit_box, 100'000));
  EXPECT_FALSE(is_large_ground(scaled(100), unit_box, 2));
  EXPECT_FALSE(is_large_ground(scaled(1e5f), Bounds3f(), 2));
}

// Of objects that are made smaller, rays move outwards in their space.
TEST(Unit_InstanceRange, RaysMayStartTheNearerTheSmallerAnInstanceIs) {
  const double of_one = farthest_origin(scaled(1));
  EXPECT_GT(of_one, 1e16);
  EXPECT_NEAR(farthest_origin(scaled(1e-6f)) / of_one, 1e-6, 1e-12);
  EXPECT_LT(farthest_origin(scaled(1, Vec3f(5e16f, 0, 0))), of_one - 4e16);
  EXPECT_EQ(farthest_origin(scaled(0)), 0);
}

TEST(Unit_InstanceRange, RaysStartAtSurfacesAndCameras) {
  Scene scene;
  const std::vector<Bounds3f> objects{unit_box};
  EXPECT_EQ(reach_of_rays(scene, Bounds3f(), objects), 1) << "the unit at the least";
  Bounds3f world = unit_box;
  world.include(Vec3f(0, -7, 0));
  EXPECT_EQ(reach_of_rays(scene, world, objects), 7);
  scene.instances.push_back(scaled(2, Vec3f(0, 0, 10)));
  scene.instances.back().object = ObjectHandle(std::size_t{0});
  EXPECT_EQ(reach_of_rays(scene, world, objects), 12);
  scene.cameras.emplace_back();
  scene.cameras.back().eye = Vec3f(30, 0, 0);
  EXPECT_EQ(reach_of_rays(scene, world, objects), 30);
  scene.cameras.back().lens_radius = 40;
  EXPECT_EQ(reach_of_rays(scene, world, objects), 40) << "rays start all over the lens";
}

}  // namespace
}  // namespace candela
