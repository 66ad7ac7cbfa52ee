// What a library's caller may hand over.
#include "scene_io/pbrt/write/write_pbrt.h"

#include <gtest/gtest.h>

#include "tests/scenes/description.h"

namespace candela::pbrt {
namespace {

using namespace description;

TEST(Errors_WritePbrt, ScenesThatAreNotValid) {
  SceneDescription scene = test::small_room();
  scene.meshes[0].triangles[0][1] = 1000000;
  const Result<WrittenScene> written = write_pbrt(scene, {});
  ASSERT_FALSE(written);
  EXPECT_TRUE(written.diagnostics.has_errors());
  scene = test::small_room();
  scene.materials[0].model = DiffuseMaterial{{Vec3d(1.0), ImageHandle(7)}};
  EXPECT_FALSE(write_pbrt(scene, {}));
}

TEST(Errors_WritePbrt, CamerasThatThereAreNot) {
  const SceneDescription scene = test::small_room();
  const Result<WrittenScene> written = write_pbrt(scene, {.camera = 7});
  ASSERT_FALSE(written);
  EXPECT_EQ(written.diagnostics.list().at(0).message, "camera 7 of a scene that has 1");
  EXPECT_TRUE(write_pbrt(scene, {.camera = 0}));
  SceneDescription without = scene;
  without.cameras.clear();
  EXPECT_FALSE(write_pbrt(without, {.camera = 1}));
}

TEST(Unit_WritePbrt, ImagesThatNobodyLooksAtAreMagenta) {
  SceneDescription scene = test::small_room();
  scene.images = {{"wood.png", Encoding::Srgb, Wrap::Repeat, {}}};
  scene.materials[0].model = DiffuseMaterial{{Vec3d(1.0), ImageHandle(0)}};
  const Result<WrittenScene> written = write_pbrt(scene, {.folder = "f", .picture = "p.exr"});
  ASSERT_TRUE(written);
  EXPECT_NE(written->text.find("[ 1 0 1 ]"), std::string::npos) << written->text;
}

}  // namespace
}  // namespace candela::pbrt
