#include "renderer/geometry/surface_point.h"

#include <random>

#include <gtest/gtest.h>

namespace candela {
namespace {

Vec3f random_unit(std::mt19937& random) {
  std::normal_distribution<float> normal;
  return normalize(Vec3f(normal(random), normal(random), normal(random)));
}

Geometry one_triangle() {
  Geometry geometry;
  geometry.positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}};
  geometry.triangles = {{0, 1, 2}};
  geometry.uvs = {{0, 0}, {1, 0}, {0, 1}};
  return geometry;
}

TEST(Unit_SurfacePoint, NormalFacesTheViewerAndSidesAreKnown) {
  const Geometry geometry = one_triangle();
  const Hit hit{.t = 1, .u = 0.25f, .v = 0.5f, .geometry = 0};
  const SurfacePoint front = make_surface_point(geometry, nullptr, hit, {0, 0, 1}, true);
  EXPECT_TRUE(front.is_front);
  EXPECT_EQ(front.geometric_normal, Vec3f(0, 0, 1));
  EXPECT_EQ(front.position, Vec3f(0.5f, 1.5f, 0));
  EXPECT_EQ(front.uv, Vec2f(0.25f, 0.5f));
  EXPECT_EQ(front.dpdu, Vec3f(2, 0, 0));
  EXPECT_EQ(front.dpdv, Vec3f(0, 3, 0));
  SurfacePoint back = make_surface_point(geometry, nullptr, hit, {0, 0, -1}, false);
  set_shading_frame(back, {0, 0, -1});
  EXPECT_FALSE(back.is_front);
  EXPECT_EQ(back.geometric_normal, Vec3f(0, 0, -1));
  EXPECT_EQ(back.shading.z, Vec3f(0, 0, -1));
}

// The square of the normal's length is beyond floats from edges of 4e9 on.
TEST(Unit_SurfacePoint, TrianglesOfAnySizeHaveANormal) {
  for (const float size : {1e-9f, 1.0f, 4e9f, 5e9f, 1e13f, 9e17f}) {
    Geometry geometry = one_triangle();
    for (Vec3f& position : geometry.positions) position *= size / 3;
    const Hit hit{.t = 1, .u = 0.25f, .v = 0.5f, .geometry = 0};
    const SurfacePoint point = make_surface_point(geometry, nullptr, hit, {0, 0, 1}, false);
    EXPECT_NEAR(point.geometric_normal.z, 1, 3e-7) << size;
    EXPECT_GT(point.offset, 0) << size;
  }
}

TEST(Unit_SurfacePoint, MirroredInstancesKeepTheirOutside) {
  const Geometry geometry = one_triangle();
  const Hit hit{.t = 1, .u = 0.25f, .v = 0.5f, .geometry = 0, .triangle = 0, .instance = 0};
  Instance mirrored;
  mirrored.x = {-1, 0, 0};
  mirrored.normal_x = {-1, 0, 0};
  const SurfacePoint point = make_surface_point(geometry, &mirrored, hit, {0, 0, 1}, false);
  EXPECT_TRUE(point.is_front);
  EXPECT_EQ(point.position, Vec3f(-0.5f, 1.5f, 0));
}

// Of which the corners, once placed, are a few numbers apart or the same.
TEST(Unit_SurfacePoint, TinyInstancesKeepTheirNormals) {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> unit(-1, 1);
  const auto any = [&] { return Vec3f(unit(random), unit(random), unit(random)); };
  for (int i = 0; i < 10000; ++i) {
    Geometry geometry = one_triangle();
    const Vec3f corner = any();
    geometry.positions = {corner, corner + 0.01f * any(), corner + 0.01f * any()};
    const Frame axes = frame_from_normal(random_unit(random));
    const float size = i % 2 == 0 ? 1e-5f : 1e-4f;
    Instance instance;
    instance.x = axes.x * size;
    instance.y = axes.y * size;
    instance.z = axes.z * size;
    instance.normal_x = axes.x;
    instance.normal_y = axes.y;
    instance.normal_z = axes.z;
    instance.translation = {-0.9f, -0.5f, 0.7f};
    const Vec3d p0(corner);
    const Vec3d edge1 = Vec3d(geometry.positions[1]) - p0;
    const Vec3d edge2 = Vec3d(geometry.positions[2]) - p0;
    if (length(cross(edge1, edge2)) < 1e-6) continue;  // a needle: its own normal rounds
    const auto turned = [&](const Vec3d& v) {
      return Vec3d(axes.x) * v.x + Vec3d(axes.y) * v.y + Vec3d(axes.z) * v.z;
    };
    const Hit hit{.t = 1, .u = 0.25f, .v = 0.5f, .geometry = 0, .triangle = 0, .instance = 0};
    const SurfacePoint point = make_surface_point(geometry, &instance, hit, axes.z, true);
    const Vec3d normal = normalize(turned(cross(edge1, edge2)));
    ASSERT_LT(length(normal * (point.is_front ? 1.0 : -1.0) - Vec3d(point.geometric_normal)), 1e-5);
    const Vec3d dpdu = turned(edge1) * double{size};  // uv: (0, 0), (1, 0), (0, 1)
    ASSERT_LT(length(dpdu - Vec3d(point.dpdu)), 1e-5 * length(dpdu) + 1e-12);
  }
}

TEST(Unit_SurfacePoint, BentNormalsMirrorAboveTheSurface) {
  std::mt19937 random(7);
  for (int i = 0; i < 200000; ++i) {
    const Vec3f geometric = random_unit(random);
    Vec3f wo = random_unit(random);
    if (dot(wo, geometric) < 0) wo = -wo;
    Vec3f shading = random_unit(random);
    if (dot(shading, geometric) < 0) shading = -shading;
    const Vec3f bent = valid_shading_normal(shading, geometric, wo);
    ASSERT_NEAR(dot(bent, bent), 1, 1e-5);
    ASSERT_GT(dot(bent, wo), 0);
    const Vec3f mirrored = bent * (2 * dot(bent, wo)) - wo;
    ASSERT_GT(dot(mirrored, geometric), -1e-6f);
    ASSERT_GT(dot(bent, geometric), dot(shading, geometric) - 1e-6f);  // towards, never beyond
    const Vec3f before = shading * (2 * dot(shading, wo)) - wo;
    if (dot(before, geometric) > 0.011f) {
      ASSERT_EQ(bent, shading);
    }
  }
}

TEST(Unit_SurfacePoint, OffsetOriginsAreOffThePlaneOnTheirSide) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int i = 0; i < 100000; ++i) {
    Geometry geometry;
    geometry.triangles = {{0, 1, 2}};
    for (int k = 0; k < 3; ++k) geometry.positions.push_back(random_unit(random) * unit(random));
    Hit hit{.t = 1, .u = unit(random) * 0.5f, .v = unit(random) * 0.5f, .geometry = 0};
    const Vec3f wo = random_unit(random);
    const SurfacePoint point = make_surface_point(geometry, nullptr, hit, wo, false);
    const Vec3d p0(geometry.positions[0]), p1(geometry.positions[1]), p2(geometry.positions[2]);
    const Vec3d exact_normal = normalize(cross(p1 - p0, p2 - p0));
    const double height = dot(exact_normal, Vec3d(spawn_ray(point, wo).origin) - p0);
    ASSERT_GT(height * dot(exact_normal, Vec3d(point.geometric_normal)), 0);
  }
}

// Four lanes of a triangle's vectors, and plain vectors as loops over paths have them.
TEST(Unit_SurfacePoint, EitherKindOfVectorGivesTheSameBits) {
  using surface_point_detail::plane_point;
  std::mt19937 random(4);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int i = 0; i < 10000; ++i) {
    const std::array<Vec3f, 3> p{random_unit(random), random_unit(random), random_unit(random)};
    const float u = unit(random) * 0.5f;
    const float v = unit(random) * 0.5f;
    const auto plain = plane_point(p[0], p[1], p[2], u, v);
    const auto lanes = plane_point(to_lanes(p[0]), to_lanes(p[1]), to_lanes(p[2]), u, v);
    ASSERT_EQ(plain.position, to_vec3(lanes.position));
    ASSERT_EQ(plain.normal, to_vec3(lanes.normal));
    ASSERT_EQ(plain.offset, lanes.offset);
  }
}

}  // namespace
}  // namespace candela
