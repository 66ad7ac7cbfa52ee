// Soups are compiled part by part: their triangles are the same, and stored with fewer numbers.
#include "renderer/scene/soup_parts.h"

#include <gtest/gtest.h>

#include "tests/image/crafted_files.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

using namespace test;
using description::Mesh;
using description::SceneDescription;

// Each triangle has a place of its own, which tells its number.
Mesh soup(std::uint32_t triangles) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const Vec3d at(i % 512, i / 512, 0);
    for (const Vec3d& corner : {Vec3d(0.0), Vec3d(0.5, 0, 0), Vec3d(0, 0.5, 0)})
      mesh.positions.push_back(at + corner);
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

constexpr auto two_and_some = static_cast<std::uint32_t>(2 * triangles_of_a_part + 1000);

SceneDescription scene_of(Mesh mesh, const Vec3d& emission = Vec3d(0.0)) {
  SceneDescription scene;
  const auto material = add_material(scene, diffuse(Vec3d(0.5)), emission);
  add_mesh(scene, std::move(mesh), material);
  set_camera(scene, {256, 128, 500}, {256, 128, 0}, 60);
  return scene;
}

// Of all geometries, one after the other, in the file's space.
std::vector<Vec3d> corners_of(const Scene& scene) {
  std::vector<Vec3d> corners;
  for (const Geometry& geometry : scene.geometries)
    for (const TriangleCorners& triangle : geometry.triangles)
      for (const std::uint32_t v : triangle)
        corners.push_back(scene.normalisation.to_file(geometry.positions[v]));
  return corners;
}

TEST(Unit_SoupParts, HaveTheTrianglesOfTheWhole) {
  const Mesh whole = soup(two_and_some);
  const Scene scene = compiled(scene_of(whole), {});
  EXPECT_EQ(scene.geometries.size(), 3u);
  const std::vector<Vec3d> corners = corners_of(scene);
  ASSERT_EQ(corners.size(), whole.positions.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
    ASSERT_LT(length(corners[i] - whole.positions[i]), 1e-4) << i;
}

TEST(Unit_SoupParts, ShareTheirCorners) {
  const Scene scene = compiled(scene_of(soup(two_and_some)), {});
  ASSERT_EQ(scene.geometries.size(), 3u);
  for (const Geometry& geometry : scene.geometries)
    EXPECT_EQ(geometry.triangles.data(), scene.geometries[0].triangles.data());
}

// Where the first lacks triangles, the second has the longest list.
TEST(Unit_SoupParts, ShareTheirCornersWhereSomeAreDropped) {
  Mesh mesh = soup(two_and_some);
  mesh.positions[7] = mesh.positions[6];
  const Scene scene = compiled(scene_of(std::move(mesh)), {});
  ASSERT_EQ(scene.geometries.size(), 3u);
  EXPECT_EQ(scene.geometries[0].triangles.size(), triangles_of_a_part - 1);
  EXPECT_EQ(scene.geometries[1].triangles.size(), triangles_of_a_part);
  for (const Geometry& geometry : scene.geometries)
    EXPECT_EQ(geometry.triangles.data(), scene.geometries[0].triangles.data());
}

// Every other triangle is half there: two geometries of each part, of which all but the last part's
// are equally long.
TEST(Unit_SoupParts, ShareTheirCornersWhereSomeHaveHoles) {
  const TemporaryFolder folder;
  const std::string half_there = folder.put(
      "half_there.png",
      crafted::png_rgba(64, 64, [](int x, int /*y*/, int) { return x < 32 ? 255u : 128u; }));
  Mesh mesh = soup(two_and_some);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    mesh.uvs.push_back({v / 3 % 2 == 0 ? 0.25f : 0.75f, 0.5f});
  SceneDescription description = scene_of(std::move(mesh));
  description.images.push_back({half_there, description::Encoding::Linear, Wrap::Clamp, {}});
  description.materials[0].opacity = {1, description::ImageHandle(0), 3};
  const Scene scene = compiled(description, {});
  ASSERT_EQ(scene.geometries.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    const Geometry& geometry = scene.geometries[i];
    EXPECT_EQ(geometry.has_cutouts, i % 2 == 1);
    EXPECT_EQ(geometry.triangles.size(), (i < 4 ? triangles_of_a_part : 1000) / 2);
    EXPECT_EQ(geometry.triangles.data(), scene.geometries[0].triangles.data());
  }
}

TEST(Unit_SoupParts, NormalsAndCoordinatesComeAlong) {
  Mesh mesh = soup(two_and_some);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.normals.push_back({0.1f * static_cast<float>(v % 7), 0, 1});
    mesh.uvs.push_back({static_cast<float>(v), 1});
  }
  for (const std::size_t part : {0u, 1u, 2u}) {
    const Mesh made = part_of(mesh, part);
    const std::size_t first = 3 * part * triangles_of_a_part;
    ASSERT_EQ(made.positions.size(), 3 * made.triangles.size());
    ASSERT_EQ(made.normals.size(), made.positions.size());
    ASSERT_EQ(made.uvs.size(), made.positions.size());
    for (std::size_t v = 0; v < made.positions.size(); ++v) {
      ASSERT_EQ(made.positions[v], mesh.positions[first + v]);
      ASSERT_EQ(made.normals[v], mesh.normals[first + v]);
      ASSERT_EQ(made.uvs[v], mesh.uvs[first + v]);
    }
  }
}

TEST(Unit_SoupParts, OtherMeshesStayWhole) {
  EXPECT_EQ(part_count(soup(triangles_of_a_part)), 1u) << "without a material";
  Mesh mesh = soup(two_and_some);
  mesh.materials = {description::MaterialHandle(0)};
  EXPECT_EQ(part_count(mesh), 3u);
  mesh.triangles[9][0] = 0;
  EXPECT_EQ(part_count(mesh), 1u) << "two triangles share a vertex";
  Mesh small = soup(triangles_of_a_part);
  small.materials = {description::MaterialHandle(0)};
  EXPECT_EQ(part_count(small), 1u);
  Mesh of_two = soup(two_and_some);
  of_two.materials.assign(two_and_some, description::MaterialHandle(0));
  EXPECT_EQ(part_count(of_two), 1u);
}

TEST(Unit_SoupParts, LampsStayWhole) {
  const Scene scene = compiled(scene_of(soup(triangles_of_a_part + 1), Vec3d(1.0)), {});
  ASSERT_EQ(scene.geometries.size(), 1u);
  EXPECT_TRUE(scene.geometries[0].is_emissive());
}

}  // namespace
}  // namespace candela
