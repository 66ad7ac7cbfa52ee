// What stands behind `#candela:` in a pbrt file.
#include <gtest/gtest.h>

#include "tests/scene_io/pbrt/pbrt_text.h"

namespace candela {
namespace {

using namespace description;
using test::pbrt_world;
using test::pbrt_world_error;

const Material& only_material(const SceneDescription& scene) {
  static const Material none;
  EXPECT_EQ(scene.materials.size(), 1u);
  return scene.materials.empty() ? none : scene.materials[0];
}

TEST(Unit_PbrtOwnParameters, AreReadAndCommentsAreNot) {
  const SceneDescription scene = pbrt_world(
      "Material \"conductor\" # \"float roughness\" 1\n"
      "  #candela: \"string model\" \"mirror\" # \"float roughness\" 2\n"
      "  #candela: \"rgb mirror.reflectance\" [ 0.1 0.2 0.3 ]\n"
      "  # candela: \"rgb eta\" 4\n"
      "Shape \"disk\"\n");
  const auto* mirror = std::get_if<MirrorMaterial>(&only_material(scene).model);
  ASSERT_NE(mirror, nullptr);
  EXPECT_EQ(mirror->reflectance.factor, Vec3d(0.1, 0.2, 0.3));
}

// The mixture beside a model of candela's own is pbrt's alone.
TEST(Unit_PbrtOwnParameters, OwnModelsReplaceMixtures) {
  const SceneDescription scene = pbrt_world(
      "MakeNamedMaterial \"a\" \"string type\" \"mix\" \"string materials\" [ \"b\" \"c\" ]\n"
      "  #candela: \"string model\" \"cooktorrance\" \"float cooktorrance.roughness\" 0.25\n"
      "NamedMaterial \"a\"\nShape \"disk\"\n");
  const auto* model = std::get_if<CookTorranceMaterial>(&only_material(scene).model);
  ASSERT_NE(model, nullptr);
  EXPECT_EQ(model->roughness.factor, 0.25);
}

TEST(Unit_PbrtOwnParameters, HeightsHaveTheScaleThatIsGiven) {
  const SceneDescription scene = pbrt_world(
      "Texture \"h\" \"float\" \"imagemap\" \"string filename\" \"picture.png\"\n"
      "Material \"diffuse\" \"texture displacement\" \"h\"\n"
      "  #candela: \"texture heights\" \"h\" \"float heightscale\" -0.5\n"
      "Shape \"disk\" \"float radius\" 10\n");
  EXPECT_EQ(only_material(scene).height_scale, -0.5);
  EXPECT_TRUE(only_material(scene).height_texture);
}

TEST(Unit_PbrtOwnParameters, NormalMapsAreRightHandedUnlessTheyFollowV) {
  const std::string disk = "\nShape \"disk\"\n";
  const std::string bumpy = "Material \"diffuse\" \"string normalmap\" \"picture.png\"";
  EXPECT_TRUE(only_material(pbrt_world(bumpy + disk)).normal_map_is_right_handed);
  const SceneDescription along_v =
      pbrt_world(bumpy + "\n #candela: \"bool normalsalongv\" true" + disk);
  EXPECT_TRUE(only_material(along_v).normal_map);
  EXPECT_FALSE(only_material(along_v).normal_map_is_right_handed);
}

TEST(Errors_PbrtOwnParameters, NameWhatTheyExpect) {
  EXPECT_EQ(pbrt_world_error("Material \"diffuse\" #candela: \"string model\" \"blob\"\n"),
            "2:30: 'model' is 'blob', expected lab, mirror or cooktorrance");
  const std::string rough = "Material \"diffuse\" #candela: \"string model\" \"cooktorrance\" ";
  EXPECT_EQ(pbrt_world_error(rough + "\"float cooktorrance.ior\" 0.5\n"),
            "2:60: 'cooktorrance.ior' is 0.5, expected at least 1");
  EXPECT_EQ(pbrt_world_error(rough + "\"float cooktorrance.roughness\" 2\n"),
            "2:60: 'cooktorrance.roughness' is 2, expected 0 to 1");
  EXPECT_EQ(pbrt_world_error(rough + "\"string cooktorrance.fresnel\" \"exact\"\n"),
            "2:60: 'cooktorrance.fresnel' needs cooktorrance.ior, or cooktorrance.eta and .k");
  EXPECT_EQ(pbrt_world_error(rough + "\"bool energycompensation\" true\n"),
            "2:60: 'energycompensation' needs \"string cooktorrance.geometry\" \"smith\"");
  EXPECT_EQ(pbrt_world_error("Material \"conductor\" \"float uroughness\" .1 \"float vroughness\" "
                             ".5 \"bool energycompensation\" true"),
            "2:66: 'energycompensation' needs one roughness, found uroughness and vroughness that "
            "differ");
  EXPECT_EQ(pbrt_world_error("LightSource \"infinite\" #candela: \"string cube\" \"a.png\"\n"),
            "2:34: 'cube' has 1 value, expected 6 image files");
}

}  // namespace
}  // namespace candela
