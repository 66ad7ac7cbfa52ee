// What is said of scenes that no light is left in.
#include <gtest/gtest.h>

#include "renderer/scene/compile.h"
#include "tests/image/crafted_files.h"
#include "tests/scenes/description.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

using namespace test;

description::SceneDescription quad_in_view() {
  description::SceneDescription scene;
  const auto material = add_material(scene, diffuse(Vec3d(0.5)));
  add_mesh(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), material);
  set_camera(scene, {0.5, 0.5, 3}, {0.5, 0.5, 0}, 40);
  return scene;
}

std::vector<std::string> warnings_of(const description::SceneDescription& scene) {
  const Result<Scene> result = compile(scene, {});
  EXPECT_TRUE(result);
  std::vector<std::string> messages;
  for (const Diagnostic& diagnostic : result.diagnostics.list())
    messages.push_back(diagnostic.message);
  return messages;
}

const std::vector<std::string> is_dark{
    "all lights are black or left out: the picture will be black"};

TEST(Unit_CompileDark, SkiesOfBlackImages) {
  const TemporaryFolder folder;
  for (const unsigned value : {0u, 9u}) {
    description::SceneDescription scene = quad_in_view();
    const std::string path =
        folder.put("sky.png", crafted::png_rgba(8, 4, [&](int, int, int) { return value; }));
    scene.images.push_back({path, description::Encoding::Linear, description::Wrap::Clamp, {}});
    description::LatLongEnvironment sky;
    sky.image = description::ImageHandle(std::size_t{0});
    scene.lights.push_back({{}, sky});
    EXPECT_EQ(warnings_of(scene), value == 0 ? is_dark : std::vector<std::string>{});
  }
}

TEST(Unit_CompileDark, LampsThatNothingWears) {
  description::SceneDescription scene = quad_in_view();
  const auto lamp = add_material(scene, diffuse(Vec3d(0.5)), Vec3d(1.0));
  EXPECT_EQ(warnings_of(scene), is_dark);
  add_mesh(scene, quad({0, 0, 1}, {1, 0, 0}, {0, 1, 0}), lamp);
  EXPECT_TRUE(warnings_of(scene).empty());
}

}  // namespace
}  // namespace candela
