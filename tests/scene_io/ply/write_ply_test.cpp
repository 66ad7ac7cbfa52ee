#include "scene_io/ply/write_ply.h"

#include <gtest/gtest.h>

#include <numeric>

#include "scene_io/ply/read_ply.h"

namespace candela::ply {
namespace {

using description::Mesh;

std::vector<std::uint32_t> all_of(const Mesh& mesh) {
  std::vector<std::uint32_t> triangles(mesh.triangles.size());
  std::iota(triangles.begin(), triangles.end(), 0u);
  return triangles;
}

Mesh read_back(const std::string& bytes) {
  Diagnostics diagnostics;
  auto mesh = parse_ply("a.ply", bytes, {.smooth_missing_normals = false}, diagnostics);
  for (const Diagnostic& d : diagnostics.list()) ADD_FAILURE() << to_string(d);
  return mesh.value_or(Mesh{});
}

// Two triangles that share an edge, with one vertex that nothing uses.
Mesh small_mesh() {
  Mesh mesh;
  mesh.positions = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0.5}, {0, 1, -2}, {1, 1, 1e-30}};
  mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 2}, {0, 0, 0}, {1, 2, 3}};
  mesh.uvs = {{0, 0}, {0.25f, 7}, {-1, 0.1f}, {0, 1}, {1, 1}};
  mesh.triangles = {{1, 2, 3}, {2, 4, 3}};
  return mesh;
}

TEST(Unit_WritePly, GivesBackTheNumbersOfTheVerticesInUse) {
  Mesh mesh = small_mesh();
  for (Vec3d& p : mesh.positions) p = Vec3d(Vec3f(p));
  const std::string bytes = write_ply(mesh, all_of(mesh), {});
  EXPECT_NE(bytes.find("property float x"), std::string::npos);
  const Mesh back = read_back(bytes);
  ASSERT_EQ(back.positions.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(back.positions[i], mesh.positions[i + 1]);
    EXPECT_EQ(back.normals[i], mesh.normals[i + 1]);
    EXPECT_EQ(back.uvs[i], mesh.uvs[i + 1]);
  }
  const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}, {1, 3, 2}};
  EXPECT_EQ(back.triangles, triangles);
}

TEST(Unit_WritePly, KeepsPositionsThatAreNoFloats) {
  Mesh mesh = small_mesh();
  mesh.positions[2].x = 0.1;
  const std::string bytes = write_ply(mesh, all_of(mesh), {});
  EXPECT_NE(bytes.find("property double x"), std::string::npos);
  EXPECT_EQ(read_back(bytes).positions[1], mesh.positions[2]);
}

TEST(Unit_WritePly, WritesTheAskedTrianglesOnly) {
  const Mesh mesh = small_mesh();
  const std::uint32_t second[] = {1};
  const Mesh back = read_back(write_ply(mesh, second, {}));
  ASSERT_EQ(back.triangles.size(), 1u);
  ASSERT_EQ(back.positions.size(), 3u);
  EXPECT_EQ(back.positions[0], mesh.positions[2]);
  EXPECT_EQ(back.positions[1], mesh.positions[4]);
}

TEST(Unit_WritePly, FillsInTextureCoordinatesWhereThereAreNone) {
  Mesh mesh = small_mesh();
  mesh.uvs.clear();
  EXPECT_TRUE(read_back(write_ply(mesh, all_of(mesh), {})).uvs.empty());
  const Mesh back = read_back(write_ply(mesh, all_of(mesh), {.missing_uv = Vec2f(0.5f)}));
  EXPECT_EQ(back.uvs, std::vector<Vec2f>(4, Vec2f(0.5f)));
}

}  // namespace
}  // namespace candela::ply
