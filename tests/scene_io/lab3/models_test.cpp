#include <gtest/gtest.h>

#include "renderer/description/validate.h"
#include "tests/scene_io/lab3/lab3_text.h"

namespace candela {
namespace {

using namespace description;
using test::error_in;
using test::said;
using test::scene_of;
using test::warning_in;

// One model of two possible materials.
std::string models(std::string_view keys) {
  return fmt::format(
      "Materials: [{{Name: a}}, {{Name: b}}]\nModels:\n  - {{Mesh: triangle.obj{}{}}}\n",
      keys.empty() ? "" : ", ", keys);
}

Transform transform_of(std::string_view keys) {
  const SceneDescription scene = scene_of(models(keys));
  return scene.instances.empty() ? Transform{} : scene.instances[0].object_to_world;
}

void expect_near(const Vec3d& a, const Vec3d& b) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-12);
}

TEST(Unit_Lab3Models, MeshMaterialAndPlace) {
  const SceneDescription scene = scene_of(models("Material: b"));
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.meshes[0].triangles.size(), 1u);
  ASSERT_EQ(scene.instances.size(), 1u);
  EXPECT_EQ(scene.instances[0].mesh, MeshHandle(0));
  EXPECT_FALSE(scene.instances[0].material_override);
  EXPECT_EQ(scene.meshes[0].materials.at(0).index, 1u);
  EXPECT_TRUE(scene.instances[0].object_to_world.is_identity());
  EXPECT_EQ(scene.instances[0].span.line, 3u);
  ASSERT_EQ(scene.files.size(), 2u);
  EXPECT_EQ(scene.files[0], test::lab3_folder() + "scene.yaml");
  EXPECT_EQ(scene.files[1], test::lab3_folder() + "triangle.obj");
}

TEST(Unit_Lab3Models, WithoutAMaterialTheFirstIsUsed) {
  EXPECT_EQ(scene_of(models("")).meshes.at(0).materials.at(0).index, 0u);
  EXPECT_EQ(scene_of(models("Material: c")).meshes.at(0).materials.at(0).index, 0u);
  EXPECT_EQ(warning_in(models("Material: bb")),
            "3:36: unknown material 'bb': the first of the file is used, as in lab3, did you mean "
            "'b'?");
}

TEST(Unit_Lab3Models, UnknownMaterialsThatAreNotToldAreCounted) {
  std::string text = models("Material: c");
  for (int i = 1; i < 30; ++i) text += "  - {Mesh: triangle.obj, Material: c}\n";
  EXPECT_EQ(test::parse_lab3_text(text).diagnostics.warning_count(), 30u);
}

TEST(Unit_Lab3Models, AbsoluteNamesOfOtherMachinesAreLookedForBesideTheScene) {
  const std::string text = "Materials: [{Name: a}]\nModels: [{Mesh: /no/such/triangle.obj}]\n";
  EXPECT_EQ(scene_of(text).meshes.size(), 1u);
  EXPECT_EQ(warning_in(text), fmt::format("2:17: file '{}triangle.obj' is taken for "
                                          "'/no/such/triangle.obj', which does not exist",
                                          test::lab3_folder()));
}

TEST(Unit_Lab3Models, WithoutMaterialsModelsAreGrey) {
  const std::string_view text = "Models: [{Mesh: triangle.obj}]\n";
  const SceneDescription scene = scene_of(text);
  ASSERT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(std::get<LabMaterial>(scene.materials[0].model).diffuse.factor, Vec3d(0.5));
  EXPECT_EQ(warning_in(text), "1:1: there are Models but no Materials: they are grey");
}

TEST(Unit_Lab3Models, NamesThatMayBeThoseOfUnreadMaterialsAreNotCalledUnknown) {
  const std::string model = "Models: [{Mesh: triangle.obj, Material: a}]\n";
  EXPECT_EQ(warning_in(model), "1:1: there are Models but no Materials: they are grey");
  const auto expect_one_error = [&](const std::string& materials, const std::string& sentence) {
    EXPECT_EQ(error_in(materials + model), sentence);
    EXPECT_TRUE(said(Severity::Warning, materials + model).empty()) << materials;
  };
  expect_one_error("Materials: a\n", "1:12: Materials: found 'a', expected a list");
  expect_one_error("Materials: [a]\n", "1:13: found 'a', expected the keys of a material");
  expect_one_error("Materials: [{Name: [a]}]\n",
                   "1:20: Name: found a list of 1 value, expected a name");
  EXPECT_EQ(warning_in("Materials: [{Nam: a}]\n" + model),
            "1:14: unknown key 'Nam' in a material, did you mean 'Name'?");
}

TEST(Unit_Lab3Models, TheTransformIsTheWrittenIntent) {
  // p' = T + R (S p): the framework's own grouping would give T + (R s) (.) p.
  const Transform transform = transform_of(
      "Translation: [10, 20, 30], Scale: [2, 3, 4], Rotation: [[0, -1, 0], [1, 0, 0], [0, 0, 1]]");
  expect_near(transform.point({1, 0, 0}), {10, 22, 30});
  expect_near(transform.point({0, 1, 0}), {7, 20, 30});
  expect_near(transform.point({0, 0, 1}), {10, 20, 34});
}

TEST(Unit_Lab3Models, RotationIsAMatrixOfRows) {
  const Transform transform = transform_of("Rotation: [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]");
  expect_near(transform.point({0, 0, 1}), {1, 0, 0});  // a quarter turn about +y
  const std::string expected =
      ", expected a matrix: a list of 3 rows of 3 numbers, such as [[1, 0, 0], [0, 1, 0], "
      "[0, 0, 1]]";
  EXPECT_EQ(error_in(models("Rotation: 30")), "3:36: Rotation: found '30'" + expected);
  EXPECT_EQ(error_in(models("Rotation: [0, 90, 0]")),
            "3:36: Rotation: found a list of 3 values" + expected);
  EXPECT_EQ(error_in(models("Rotation: [[1, 0, 0], [0, 1, 0]]")),
            "3:36: Rotation: found a list of 2 values" + expected);
  EXPECT_EQ(warning_in(models("Rotation: [[2, 0, 0], [0, 1, 0], [0, 0, 1]]")),
            "3:36: Rotation is no rotation: its rows are not of length 1 and at right angles; it "
            "is used as it stands");
}

TEST(Unit_Lab3Models, MirroredModelsAreFine) {
  EXPECT_LT(transform_of("Scale: [-1, 1, 1]").determinant(), 0);
}

TEST(Errors_Lab3Models, SingularTransforms) {
  EXPECT_EQ(error_in(models("Scale: [1, 0, 1]")),
            "3:33: Scale: found a 0, which flattens the model; expected numbers other than 0");
  EXPECT_EQ(error_in(models("Rotation: [[1, 2, 3], [2, 4, 6], [0, 0, 1]]")),
            "3:36: Rotation: the matrix is singular and flattens the model");
  EXPECT_EQ(error_in(models("Rotation: [[1, 0, 0], [0, 0, 0], [0, 0, 1]]")),
            "3:36: Rotation: the matrix is singular and flattens the model");
  EXPECT_EQ(error_in(models("Scale: 2")),
            "3:33: Scale: found '2', expected a list of 3 numbers, such as [2, 2, 2]");
}

TEST(Unit_Lab3Models, InstancesShareTheMesh) {
  const SceneDescription scene = scene_of(
      models("Scale: [2, 2, 2], Instances: [{Translation: [1, 0, 0]}, {Scale: [3, 3, 3]}, {}]"));
  EXPECT_EQ(scene.meshes.size(), 1u);
  ASSERT_EQ(scene.instances.size(), 3u);
  // Each on top of the model's own transform.
  expect_near(scene.instances[0].object_to_world.point({1, 1, 1}), {3, 2, 2});
  expect_near(scene.instances[1].object_to_world.point({1, 1, 1}), {6, 6, 6});
  expect_near(scene.instances[2].object_to_world.point({1, 1, 1}), {2, 2, 2});
  EXPECT_EQ(warning_in(models("Instances: []")), "3:26: Instances is empty: the model is nowhere");
  EXPECT_EQ(warning_in(models("Instances:")), "3:26: Instances is empty: the model is nowhere");
  const std::string map = models("Instances: {Translation: [1, 0, 0]}");
  EXPECT_EQ(error_in(map), "3:37: Instances: found a map of keys, expected a list");
  EXPECT_TRUE(said(Severity::Warning, map).empty());
  EXPECT_EQ(warning_in(models("Instances: [{Scal: 5}]")),
            "3:39: unknown key 'Scal' in an instance, did you mean 'Scale'?");
}

TEST(Unit_Lab3Models, AFileIsReadOnceHoweverManyModelsUseIt) {
  const SceneDescription scene = scene_of(
      "Materials: [{Name: a}, {Name: b}]\nModels:\n  - {Mesh: triangle.obj, Material: a}\n"
      "  - {Mesh: triangle.obj, Material: b, Translation: [5, 0, 0]}\n");
  EXPECT_EQ(scene.meshes.size(), 1u);
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_FALSE(scene.instances[0].material_override);
  EXPECT_EQ(scene.instances[1].material_override.index, 1u);
  EXPECT_EQ(scene.instances[1].object_to_world.translation, Vec3d(5, 0, 0));
  EXPECT_EQ(scene.files.size(), 2u);
}

TEST(Unit_Lab3Models, PlyMeshes) {
  const SceneDescription scene =
      scene_of("Materials: [{Name: a}, {Name: b}]\nModels: [{Mesh: triangle.ply, Material: b}]\n");
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.meshes[0].positions.size(), 3u);
  ASSERT_EQ(scene.meshes[0].materials.size(), 1u);
  EXPECT_EQ(scene.meshes[0].materials[0].index, 1u);
}

TEST(Unit_Lab3Models, ComplexModelsBringTheirMaterials) {
  const SceneDescription scene = scene_of("ComplexModels: [{Mesh: with_mtl.obj}]\n");
  ASSERT_EQ(scene.meshes.size(), 2u);
  EXPECT_EQ(scene.instances.size(), 2u);
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.materials[0].name, "red");
  EXPECT_EQ(scene.materials[0].emission, Vec3d(0.0));  // Ke is ignored, as in lab3
  EXPECT_EQ(scene.files.size(), 3u);
  EXPECT_EQ(scene.meshes[1].materials.at(0).index, 1u);
}

TEST(Unit_Lab3Models, MtlCountsInFullWhenAskedTo) {
  LoadOptions options;
  options.use_mtl_materials = true;
  const SceneDescription scene = scene_of("ComplexModels: [{Mesh: with_mtl.obj}]\n", options);
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.materials[0].emission, Vec3d(2, 0, 0));
}

TEST(Unit_Lab3Models, ModelsIgnoreTheMtl) {
  const SceneDescription scene =
      scene_of("Materials: [{Name: a}]\nModels: [{Mesh: with_mtl.obj}]\n");
  EXPECT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(scene.files.size(), 2u);
}

TEST(Unit_Lab3Models, TheLabsMaterialsComeBeforeThoseOfMtls) {
  const SceneDescription scene = scene_of(
      "ComplexModels: [{Mesh: with_mtl.obj}]\nModels: [{Mesh: triangle.obj}]\nMaterials: [{Name: "
      "a}]\n");
  ASSERT_EQ(scene.materials.size(), 3u);
  EXPECT_EQ(scene.materials[0].name, "a");
  EXPECT_EQ(scene.meshes.at(0).materials.at(0).index, 0u);
}

TEST(Unit_Lab3Models, ComplexModelsHaveNoPlace) {
  const std::string_view text = "ComplexModels: [{Mesh: with_mtl.obj, Translation: [1, 0, 0]}]\n";
  EXPECT_TRUE(scene_of(text).instances.at(0).object_to_world.is_identity());
  EXPECT_EQ(warning_in(text),
            "1:38: key 'Translation' is not read in ComplexModels, whose meshes "
            "bring their materials and stay where they are");
}

TEST(Unit_Lab3Models, WithoutAMeshTheyAreLeftOut) {
  for (const char* material : {"a", "b"})
    EXPECT_EQ(
        warning_in(fmt::format("Materials: [{{Name: a}}]\nModels: [{{Material: {}}}]\n", material)),
        "2:10: this model has no Mesh and is left out");
}

TEST(Unit_Lab3Models, MaterialsThatNoModelUsesAreFoundByLint) {
  const auto warnings = lint(scene_of(models("Material: b, Translation: [0, 0, -9]")));
  ASSERT_EQ(warnings.list().size(), 1u);
  EXPECT_EQ(to_string(warnings.list()[0]),
            test::lab3_folder() + "scene.yaml:1:13: warning: material 'a' is used by no model");
}

TEST(Errors_Lab3Models, MeshesThatAreNoFiles) {
  const auto mesh = [](std::string_view name) {
    return fmt::format("Materials: [{{Name: a}}]\nModels: [{{Mesh: {}}}]\n", name);
  };
  EXPECT_EQ(error_in(mesh("triangel.obj")),
            "2:17: 'triangel.obj': no such file for a mesh, did you mean 'triangle.obj'?");
  EXPECT_EQ(error_in(mesh("zzz/zzz.obj")), "2:17: 'zzz/zzz.obj': no such file for a mesh");
  EXPECT_EQ(error_in(mesh("folder")), "2:17: 'folder': this is a folder where a mesh was expected");
  EXPECT_EQ(error_in(mesh("pipe")), "2:17: 'pipe': this is a FIFO where a mesh was expected");
  EXPECT_EQ(error_in(mesh("/dev/null")),
            "2:17: '/dev/null': this is a device where a mesh was expected");
  EXPECT_EQ(error_in(mesh("picture.png")),
            "2:17: Mesh: found 'picture.png', expected an .obj or .ply file");
  EXPECT_EQ(error_in(mesh("[a.obj]")),
            "2:17: Mesh: found a list of 1 value, expected the name of a file");
  EXPECT_EQ(error_in("ComplexModels: [{Mesh: triangle.ply}]\n"),
            "1:24: Mesh: found 'triangle.ply', expected an .obj file, which brings its materials");
}

}  // namespace
}  // namespace candela
