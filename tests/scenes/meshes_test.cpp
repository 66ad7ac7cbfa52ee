#include "tests/scenes/meshes.h"

#include <gtest/gtest.h>

#include "tests/scenes/description.h"

namespace candela::test {
namespace {

struct Measures {
  double area = 0;
  double volume = 0;  // signed: positive where the winding is outward
};

Measures measures(const description::Mesh& mesh) {
  Measures m;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec3d a = mesh.positions[i];
    const Vec3d n = cross(mesh.positions[j] - a, mesh.positions[k] - a);
    m.area += length(n) / 2;
    m.volume += dot(a, n) / 6;
  }
  return m;
}

TEST(Unit_TestMeshes, BoxFacesOutward) {
  const Measures m = measures(box({-1, -2, -3}, {1, 2, 3}));
  EXPECT_DOUBLE_EQ(m.area, 2 * (8 + 24 + 12));
  EXPECT_DOUBLE_EQ(m.volume, 48);
  EXPECT_DOUBLE_EQ(measures(inside_out(box({-1, -2, -3}, {1, 2, 3}))).volume, -48);
}

TEST(Unit_TestMeshes, SphereFacesOutwardAndConverges) {
  const description::Mesh mesh = sphere({0.25, 0, 0}, 2, 4);
  const Measures m = measures(mesh);
  EXPECT_EQ(mesh.triangles.size(), 20u * 256u);
  EXPECT_NEAR(m.volume, 4.0 / 3.0 * 3.14159265 * 8, 0.1);
  EXPECT_GT(dot(Vec3d(mesh.normals[7]), mesh.positions[7] - Vec3d(0.25, 0, 0)), 0);
}

TEST(Unit_TestMeshes, RoomFacesInward) {
  const description::SceneDescription room = small_room();
  for (std::size_t i = 0; i < 6; ++i) {
    const description::Mesh& mesh = room.meshes[i];
    const auto& [a, b, c] = mesh.triangles[0];
    const Vec3d& p = mesh.positions[a];
    EXPECT_LT(dot(cross(mesh.positions[b] - p, mesh.positions[c] - p), p), 0) << i;
  }
}

}  // namespace
}  // namespace candela::test
