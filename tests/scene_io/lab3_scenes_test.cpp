// The nine scenes of the course, unmodified, where they are present.
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "renderer/description/validate.h"
#include "scene_io/load.h"
#include "tests/scene_io/shared_scenes.h"

namespace candela {
namespace {

using namespace description;
namespace fs = std::filesystem;

struct Expected {
  const char* name;
  std::size_t triangles, meshes, materials, images, point_lights, suns, skyboxes;
  Vec3d eye;
};

constexpr Expected expected_scenes[] = {
    {"breakfast_room", 269538, 13, 15, 3, 0, 1, 0, {0, 2, 9.8}},
    {"bunny", 69451, 1, 1, 6, 0, 1, 1, {0, 0, 4}},
    {"cornell_box", 30, 5, 4, 0, 1, 0, 0, {278, 273, -800}},
    {"floor", 2, 1, 1, 1, 1, 0, 0, {0, 2, 4}},
    {"sibenik", 73564, 14, 15, 5, 0, 1, 0, {-12, -12, 0}},
    {"sponza", 262205, 24, 25, 37, 1, 0, 0, {900, 300, -20}},
    {"sports_car", 403614, 10, 38, 0, 0, 1, 0, {-5, 3, 5}},
    {"teapot", 4032, 1, 1, 6, 0, 1, 1, {0, 0, -80}},
    {"white_oak", 36760, 4, 4, 4, 0, 1, 0, {0, 500, 1100}},
};

template <class Kind>
std::size_t count_lights(const SceneDescription& scene) {
  return static_cast<std::size_t>(
      std::count_if(scene.lights.begin(), scene.lights.end(),
                    [](const Light& light) { return std::holds_alternative<Kind>(light.kind); }));
}

class Unit_Lab3Scenes : public ::testing::TestWithParam<Expected> {};

TEST_P(Unit_Lab3Scenes, LoadsWithoutAWord) {
  const Expected& expected = GetParam();
  const auto path = shared_scene(fmt::format("lab3/{0}/{0}.yaml", expected.name));
  if (!path) GTEST_SKIP() << expected.name << " is not there";
  const Result<SceneDescription> scene = load(*path, {});
  for (const Diagnostic& diagnostic : scene.diagnostics.list())
    ADD_FAILURE() << to_string(diagnostic);
  ASSERT_TRUE(scene);
  std::size_t triangles = 0;
  for (const Mesh& mesh : scene->meshes) triangles += mesh.triangles.size();
  EXPECT_EQ(triangles, expected.triangles);
  EXPECT_EQ(scene->meshes.size(), expected.meshes);
  EXPECT_EQ(scene->instances.size(), expected.meshes);
  EXPECT_EQ(scene->materials.size(), expected.materials);
  EXPECT_EQ(scene->images.size(), expected.images);
  EXPECT_EQ(count_lights<PointLight>(*scene), expected.point_lights);
  EXPECT_EQ(count_lights<DirectionalLight>(*scene), expected.suns);
  EXPECT_EQ(count_lights<CubeEnvironment>(*scene), expected.skyboxes);
  EXPECT_EQ(count_lights<ConstantEnvironment>(*scene), 1 - expected.skyboxes);
  EXPECT_EQ(scene->lab_ambient, Vec3d(0.05));
  ASSERT_EQ(scene->cameras.size(), 1u);
  EXPECT_EQ(scene->cameras[0].eye, expected.eye);
  EXPECT_TRUE(validate(*scene).list().empty());
  EXPECT_TRUE(lint(*scene).list().empty());
}

INSTANTIATE_TEST_SUITE_P(, Unit_Lab3Scenes, ::testing::ValuesIn(expected_scenes),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Unit_Lab3Assets, OurOwnScenesLoadWithoutAWord) {
  std::size_t count = 0;
  for (const auto& folder : fs::directory_iterator(fs::path(CANDELA_SOURCE_DIR) / "assets")) {
    const fs::path path = folder.path() / (folder.path().filename().string() + ".yaml");
    if (!fs::exists(path)) continue;
    ++count;
    const Result<SceneDescription> scene = load(path.string(), {});
    for (const Diagnostic& diagnostic : scene.diagnostics.list())
      ADD_FAILURE() << to_string(diagnostic);
    ASSERT_TRUE(scene) << path;
    EXPECT_TRUE(validate(*scene).list().empty()) << path;
    EXPECT_TRUE(lint(*scene).list().empty()) << path;
    EXPECT_TRUE(scene->defaults.width);
  }
  EXPECT_GE(count, 4u);
}

}  // namespace
}  // namespace candela
