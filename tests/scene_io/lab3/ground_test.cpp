#include <gtest/gtest.h>

#include "scene_io/lab3/read_lab3.h"
#include "tests/scene_io/lab3/lab3_text.h"

namespace candela {
namespace {

using namespace description;

constexpr std::string_view text =
    "Materials: [{Name: a}]\nModels: [{Mesh: quad.obj}]\nCameras: [{ZFar: 200}]\n";

SceneDescription with_ground(const std::string& scene_name, std::string_view scene_text = text) {
  LoadOptions options;
  options.lab3_ground = test::lab3_folder() + "picture.png";
  auto scene = lab3::parse_lab3(test::lab3_folder() + scene_name, scene_text, options);
  EXPECT_TRUE(scene);
  return scene ? std::move(*scene) : SceneDescription{};
}

TEST(Unit_Lab3Ground, IsASquareBelowTheModels) {
  const SceneDescription scene = with_ground("sports_car.yaml");
  ASSERT_EQ(scene.meshes.size(), 2u);
  const Mesh& ground = scene.meshes[1];
  ASSERT_EQ(ground.positions.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(ground.positions[i].y, -2);  // quad.obj's
    EXPECT_EQ(std::abs(ground.positions[i].x), 100);
    EXPECT_EQ(std::abs(ground.positions[i].z), 100);
    EXPECT_EQ(std::abs(ground.uvs.at(i).x), 15);
    EXPECT_EQ(std::abs(ground.uvs.at(i).y), 15);
  }
  EXPECT_TRUE(ground.normals.empty());
  ASSERT_EQ(ground.triangles.size(), 2u);
  for (const auto& [a, b, c] : ground.triangles) {
    const Vec3d& p = ground.positions[a];
    EXPECT_GT(cross(ground.positions[b] - p, ground.positions[c] - p).y, 0);
  }
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_TRUE(scene.instances[1].object_to_world.is_identity());
}

// Not at the corner of a turned box about them, nor at a lamp.
TEST(Unit_Lab3Ground, LiesAtTheLowestVertex) {
  const std::string turned =
      "Materials: [{Name: a}]\nCameras: [{ZFar: 200}]\n"
      "Lights: [{Type: Area, p0: [0, -70, 0], p1: [1, -70, 0], p2: [0, -70, 1]}]\n"
      "Models:\n"
      "- {Mesh: triangle.obj, Rotation: [[-.8, .6, 0], [-.6, -.8, 0], [0, 0, 1]]}\n"
      "- {Mesh: triangle.obj, Rotation: [[-.8, -.6, 0], [.6, -.8, 0], [0, 0, 1]], Translation: [9, "
      "0, 0]}"
      "\n";
  const SceneDescription scene = with_ground("any.yaml", turned);
  ASSERT_EQ(scene.instances.size(), 3u);
  double lowest = 1e9;
  for (std::size_t i = 0; i < 2; ++i)
    for (const Vec3d& p : scene.meshes[scene.instances[i].mesh.index].positions)
      lowest = std::min(lowest, scene.instances[i].object_to_world.point(p).y);
  EXPECT_EQ(scene.meshes[scene.instances[2].mesh.index].positions.at(0).y, lowest);
}

TEST(Unit_Lab3Ground, CarriesThePictureAndNoHighlight) {
  const SceneDescription scene = with_ground("sports_car.yaml");
  const auto& lab = std::get<LabMaterial>(scene.materials.at(1).model);
  ASSERT_TRUE(lab.diffuse.map);
  EXPECT_EQ(scene.images.at(lab.diffuse.map.index).path, test::lab3_folder() + "picture.png");
  EXPECT_EQ(scene.images.at(lab.diffuse.map.index).encoding, Encoding::LabGamma);
  EXPECT_EQ(lab.specular.factor, Vec3d(0.0));
  EXPECT_EQ(lab.shininess, 0);
}

TEST(Unit_Lab3Ground, LiesAtTheOaksRoots) {
  EXPECT_EQ(with_ground("white_oak.yaml").meshes.at(1).positions.at(0).y, -10);
  EXPECT_EQ(with_ground("white_oak.yaml.gz").meshes.at(1).positions.at(0).y, -10);
  EXPECT_EQ(with_ground("any.yaml").meshes.at(1).positions.at(0).y, -2);
}

TEST(Unit_Lab3Ground, IsThereOnlyWhenAskedFor) {
  EXPECT_EQ(test::scene_of(text).meshes.size(), 1u);
}

TEST(Errors_Lab3Ground, PicturesThatAreNoFiles) {
  LoadOptions options;
  options.lab3_ground = "no/such.png";
  EXPECT_EQ(test::error_in(text, options), "--lab3-ground 'no/such.png': no such file");
}

}  // namespace
}  // namespace candela
