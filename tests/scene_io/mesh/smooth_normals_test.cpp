#include "scene_io/mesh/smooth_normals.h"

#include <gtest/gtest.h>

namespace candela::mesh {
namespace {

description::Mesh card(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  description::Mesh mesh;
  mesh.positions = {{0.1, 0.2, 0.3}, {1.13, 0.21, 0.37}, {1.07, 1.19, 0.71}, {0.03, 1.3, 0.33}};
  mesh.triangles = triangles;
  compute_smooth_normals(mesh);
  return mesh;
}

TEST(Unit_SmoothNormals, PointWhereTheTrianglesDo) {
  const description::Mesh mesh = card({{0, 1, 2}, {0, 2, 3}});
  for (const Vec3f& normal : mesh.normals) {
    EXPECT_NEAR(length_squared(normal), 1, 1e-6);
    EXPECT_GT(normal.z, 0.9f);
  }
}

// Both sides of a sheet on the same vertices: what rounding leaves of their sum has any direction.
TEST(Unit_SmoothNormals, OfOppositeFacesThereIsNone) {
  for (const Vec3f& normal : card({{0, 1, 2}, {0, 2, 3}, {2, 1, 0}, {3, 2, 0}}).normals)
    EXPECT_EQ(normal, Vec3f(0));
}

// A needle's area is far below the squares of its edges, and none of it is rounding.
TEST(Unit_SmoothNormals, NeedlesHaveThem) {
  description::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-11, 0}};
  mesh.triangles = {{0, 1, 2}};
  compute_smooth_normals(mesh);
  for (const Vec3f& normal : mesh.normals) EXPECT_EQ(normal, Vec3f(0, 0, 1));
}

}  // namespace
}  // namespace candela::mesh
