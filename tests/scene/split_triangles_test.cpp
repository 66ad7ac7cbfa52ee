#include "renderer/scene/split_triangles.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/scenes/meshes.h"

namespace candela {
namespace {

using namespace test;

description::Mesh ground(double half_size) {
  description::Mesh mesh =
      quad({-half_size, 0, -half_size}, {0, 0, 2 * half_size}, {2 * half_size, 0, 0});
  mesh.materials = {description::MaterialHandle(0), description::MaterialHandle(1)};
  return mesh;
}

double area_of(const description::Mesh& mesh, std::uint32_t material) {
  double area = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    if (mesh.materials[i].index == material)
      area += 0.5 *
              cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]).y;
  }
  return area;
}

TEST(Unit_SplitTriangles, LeavesOrdinaryMeshesAlone) {
  EXPECT_FALSE(split_large_triangles(box({-1, -1, -1}, {1, 1, 1}), {}));
  const Transform shrunk{Mat3d(1e-6), Vec3d(0.0)};
  EXPECT_FALSE(split_large_triangles(ground(1e6), shrunk));
  // Far away, too, what is no larger than its distance.
  EXPECT_FALSE(split_large_triangles(ground(30), {Mat3d(1.0), {0, 100, 0}}));
}

TEST(Unit_SplitTriangles, CutsToTheDistanceAndKeepsTheSurface) {
  for (const double size : {10.0, 1e3, 1e6, 1e15}) {
    const auto split = split_large_triangles(ground(size), {});
    ASSERT_TRUE(split);
    EXPECT_LT(split->triangles.size(), 100 * (1 + std::log2(size)));
    for (const std::uint32_t material : {0u, 1u})
      EXPECT_NEAR(area_of(*split, material) / (2 * size * size), 1, 1e-12);
    for (const auto& t : split->triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d& a = split->positions[t[k]];
        const Vec3d& b = split->positions[t[(k + 1) % 3]];
        EXPECT_LE(length(b - a), std::max({4.0, length(a), length(b)}));
      }
    // uvs go on saying where on the square a vertex lies.
    for (std::size_t i = 0; i < split->positions.size(); ++i) {
      EXPECT_NEAR(split->uvs[i].y, (split->positions[i].x / size + 1) / 2, 1e-6);
      EXPECT_NEAR(split->uvs[i].x, (split->positions[i].z / size + 1) / 2, 1e-6);
    }
  }
}

// Inside, every edge has a triangle on either side.
TEST(Unit_SplitTriangles, TrianglesStayJoined) {
  const auto split = split_large_triangles(ground(1e6), {});
  ASSERT_TRUE(split);
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& t : split->triangles)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(edges.insert({t[k], t[(k + 1) % 3]}).second);
  for (const auto& [a, b] : edges) {
    const Vec3d middle = (split->positions[a] + split->positions[b]) * 0.5;
    const bool is_border = std::max(std::abs(middle.x), std::abs(middle.z)) == 1e6;
    EXPECT_EQ(edges.contains({b, a}), !is_border);
  }
}

// A million millions long and as much longer than wide: by halves there would be millions.
TEST(Unit_SplitTriangles, LeavesSliversWhole) {
  description::Mesh mesh;
  mesh.positions = {
      {-0.5, -0.6e12, 0.6}, {-0.98, -.05e12, 1e24}, {0.02538, 0.83e12, 0}, {0, .5e12, -0.7629}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto split = split_large_triangles(mesh, {});
  EXPECT_LT(split ? split->triangles.size() : 2, 40000u);
  // Others of the same mesh are cut as ever.
  description::Mesh both = merged(ground(1e6), mesh);
  both.materials.clear();
  const auto others = split_large_triangles(both, {});
  ASSERT_TRUE(others);
  EXPECT_GT(others->triangles.size(), 100u);
  EXPECT_LT(others->triangles.size(), 40000u);
}

}  // namespace
}  // namespace candela
