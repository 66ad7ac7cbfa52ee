// What a geometry takes of a mesh is the same whether it takes the arrays as they are or copies
// vertex by vertex.
#include "renderer/scene/pick_triangles.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace candela {
namespace {

// Of triangles that share some vertices; each vertex is first used in its turn.
description::Mesh mesh_in_order(std::uint32_t vertices) {
  std::mt19937 random(3);
  const auto number = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
  description::Mesh mesh;
  for (std::uint32_t v = 0; v < vertices; ++v) {
    mesh.positions.emplace_back(number(), number(), number());
    mesh.normals.emplace_back(number(), number(), number());
    mesh.uvs.emplace_back(number(), number());
  }
  for (std::uint32_t v = 2; v < vertices; ++v) mesh.triangles.push_back({v - 2, v - 1, v});
  return mesh;
}

Geometry all_picked(const description::Mesh& mesh, bool is_mirrored, std::vector<bool>& is_kept) {
  MeshArrays arrays = normalised_arrays(mesh, Transform());
  arrays.uvs = mesh.uvs;
  std::vector<std::uint32_t> triangles(mesh.triangles.size());
  std::iota(triangles.begin(), triangles.end(), 0u);
  is_kept.assign(mesh.positions.size(), false);
  return picked(mesh, arrays, triangles, 0, is_mirrored, is_kept);
}

TEST(Unit_PickTriangles, ArraysAsTheyAreSayWhatCopiesSay) {
  const description::Mesh mesh = mesh_in_order(50);
  // A vertex that nothing uses, in front, so that every other one must be renumbered.
  description::Mesh shifted = mesh;
  shifted.positions.insert(shifted.positions.begin(), Vec3d(9.0));
  shifted.normals.insert(shifted.normals.begin(), Vec3f(0, 0, 1));
  shifted.uvs.insert(shifted.uvs.begin(), Vec2f(9.0f));
  for (auto& t : shifted.triangles)
    for (std::uint32_t& v : t) ++v;
  for (const bool is_mirrored : {false, true}) {
    std::vector<bool> is_kept, is_kept_of_shifted;
    const Geometry taken = all_picked(mesh, is_mirrored, is_kept);
    const Geometry copied = all_picked(shifted, is_mirrored, is_kept_of_shifted);
    EXPECT_EQ(taken.positions, copied.positions);
    EXPECT_EQ(taken.normals, copied.normals);
    EXPECT_EQ(taken.uvs, copied.uvs);
    EXPECT_EQ(taken.triangles, copied.triangles);
    EXPECT_FALSE(taken.normals.empty());
    EXPECT_EQ(is_kept, std::vector<bool>(50, true));
    EXPECT_FALSE(is_kept_of_shifted[0]);
    EXPECT_GT(taken.positions.capacity(), taken.positions.size());  // for Embree
  }
}

// A part of the triangles that meets the first vertices in order is no reason to take all.
TEST(Unit_PickTriangles, APartTakesItsOwnVerticesOnly) {
  const description::Mesh mesh = mesh_in_order(50);
  MeshArrays arrays = normalised_arrays(mesh, Transform());
  const std::vector<std::uint32_t> first{0, 1, 2};
  std::vector<bool> is_kept(50, false);
  const Geometry part = picked(mesh, arrays, first, 0, false, is_kept);
  EXPECT_EQ(part.positions.size(), 5u);
  EXPECT_EQ(arrays.positions.size(), 50u);
  EXPECT_TRUE(is_kept[4]);
  EXPECT_FALSE(is_kept[5]);
}

}  // namespace
}  // namespace candela
