// Rays between surfaces and points of lights.
#include "renderer/light/shadow_segment.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

SurfacePoint floor_at(float height) {
  SurfacePoint point;
  point.position = {0, 0, height};
  point.offset = 1e-6f;
  return point;
}

TEST(Unit_ShadowSegment, GoesOnBehindASurfaceToTheSameEnd) {
  const Ray ray = shadow_segment(floor_at(0), {0, 0, 1}, {0, 0, 4});
  const Ray rest = shadow_ray_behind(ray, floor_at(1));
  EXPECT_GT(rest.origin.z, 1);
  EXPECT_FLOAT_EQ(rest.origin.z + rest.direction.z, 4);
  EXPECT_EQ(rest.t_max, ray.t_max);
  EXPECT_EQ(shadow_ray_behind({{}, {0, 0, 1}, infinity}, floor_at(1)).t_max, infinity);
}

TEST(Unit_ShadowSegment, HasNoRestWhereTheSurfaceIsItsEnd) {
  const Ray ray = shadow_segment(floor_at(0), {0, 0, 1}, {0, 0, 4});
  EXPECT_EQ(shadow_ray_behind(ray, floor_at(4)).t_max, 0);
}

}  // namespace
}  // namespace candela
