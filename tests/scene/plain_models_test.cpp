// Which geometries' surfaces paths may leave side by side (Scene::plain_models).
#include <gtest/gtest.h>

#include "renderer/scene/compile.h"
#include "tests/image/crafted_files.h"
#include "tests/scenes/description.h"
#include "tests/scenes/exact_sphere.h"
#include "tests/scenes/render_scene.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

using namespace test;
using description::CoatedDiffuseMaterial;
using description::ConductorMaterial;
using description::CookTorranceMaterial;
using description::LabMaterial;
using description::SceneDescription;

// Of one surface of this material.
template <class Model>
PlainModel model_of(const Model& model, const SceneDescription& with = {}) {
  SceneDescription scene = with;
  add_mesh(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), add_material(scene, model));
  set_camera(scene, {0.5, 0.5, 3}, {0.5, 0.5, 0}, 40);
  const Scene compiled_scene = compiled(scene, {});
  EXPECT_EQ(compiled_scene.plain_models.size(), 1u);
  return compiled_scene.plain_models.at(0);
}

TEST(Unit_PlainModels, OfEachKindOfMaterial) {
  EXPECT_EQ(model_of(diffuse(Vec3d(0.5))), PlainModel::Diffuse);
  EXPECT_EQ(model_of(CookTorranceMaterial{}), PlainModel::CookTorrance);
  CookTorranceMaterial smith;
  smith.geometry = description::GeometryModel::Smith;
  EXPECT_EQ(model_of(smith), PlainModel::SmithCookTorrance);
  CookTorranceMaterial exact;
  exact.ior = 1.5;
  exact.fresnel = description::FresnelModel::Exact;
  EXPECT_EQ(model_of(exact), PlainModel::None);
  LabMaterial lab;
  EXPECT_EQ(model_of(lab), PlainModel::Diffuse);
  lab.specular = {Vec3d(0.3), {}};
  lab.shininess = 40;
  EXPECT_EQ(model_of(lab), PlainModel::Lab);
  EXPECT_EQ(model_of(description::MirrorMaterial{}), PlainModel::Mirror);
  EXPECT_EQ(model_of(description::DielectricMaterial{.is_thin = true}), PlainModel::None);
}

// Lanes know smooth glass alone: of one width that float cannot tell from none, from either side.
TEST(Unit_PlainModels, OfGlass) {
  const auto glass = [](double ior, double along, double across) {
    description::DielectricMaterial material;
    material.ior = ior;
    material.roughness = {along, {}, 0};
    material.roughness_across = {across, {}, 0};
    return model_of(material);
  };
  EXPECT_EQ(model_of(description::DielectricMaterial{}), PlainModel::Glass);
  EXPECT_EQ(glass(1.5, 0, 0), PlainModel::Glass);
  EXPECT_EQ(glass(1.5, 0.2, 0.2), PlainModel::None);
  EXPECT_EQ(glass(1.5, 0, 0.2), PlainModel::None);
  EXPECT_EQ(glass(1, 0.5, 0.5), PlainModel::Glass);  // nothing is refracted
  const TemporaryFolder folder;
  const std::string png =
      folder.put("rough.png", crafted::png_rgba(8, 8, [](int x, int, int) { return 30u * x; }));
  SceneDescription with_image;
  with_image.images.push_back({png, description::Encoding::Linear, description::Wrap::Repeat, {}});
  const description::DielectricMaterial mapped{.roughness = {1, description::ImageHandle(0), 0}};
  EXPECT_EQ(model_of(mapped, with_image), PlainModel::None);
}

// Lanes know neither smooth metals and coats nor widths that change from place to place.
TEST(Unit_PlainModels, OfMetalsAndCoats) {
  const description::ScalarInput rough{0.2, {}, 0};
  const description::ScalarInput smooth{0.0, {}, 0};
  const description::ScalarInput across{0.4, {}, 0};
  EXPECT_EQ(model_of(ConductorMaterial{.roughness = rough}), PlainModel::Conductor);
  EXPECT_EQ(model_of(ConductorMaterial{.roughness = smooth}), PlainModel::None);
  EXPECT_EQ(model_of(ConductorMaterial{.roughness = rough, .energy_compensation = true}),
            PlainModel::None);
  EXPECT_EQ(model_of(ConductorMaterial{.roughness = rough, .roughness_across = across}),
            PlainModel::None);
  EXPECT_EQ(model_of(CoatedDiffuseMaterial{.coat = {.roughness = rough}}),
            PlainModel::CoatedDiffuse);
  EXPECT_EQ(model_of(CoatedDiffuseMaterial{.coat = {.roughness = smooth}}), PlainModel::None);
  EXPECT_EQ(
      model_of(CoatedDiffuseMaterial{.coat = {.roughness = rough, .roughness_across = across}}),
      PlainModel::None);
  EXPECT_EQ(model_of(description::CoatedConductorMaterial{.coat = {.roughness = rough}}),
            PlainModel::None);
  const TemporaryFolder folder;
  const std::string png =
      folder.put("widths.png", crafted::png_rgba(8, 8, [](int x, int, int) { return 30u * x; }));
  SceneDescription with_image;
  with_image.images.push_back({png, description::Encoding::Linear, description::Wrap::Repeat, {}});
  const description::ScalarInput varying{1, description::ImageHandle(0), 0};
  EXPECT_EQ(model_of(ConductorMaterial{.roughness = varying}, with_image), PlainModel::None);
  EXPECT_EQ(model_of(CoatedDiffuseMaterial{.coat = {.roughness = varying}}, with_image),
            PlainModel::None);
}

TEST(Unit_PlainModels, SpheresAreNotPlain) {
  SceneDescription scene;
  const auto material = add_material(scene, diffuse(Vec3d(0.5)));
  add_mesh(scene, exact_sphere(0.2), material);
  add_mesh(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), material);
  set_camera(scene, {0.5, 0.5, 3}, {0.5, 0.5, 0}, 40);
  const Scene compiled_scene = compiled(scene, {});
  ASSERT_EQ(compiled_scene.plain_models.size(), compiled_scene.geometries.size());
  ASSERT_EQ(compiled_scene.geometries.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(compiled_scene.plain_models[i], compiled_scene.geometries[i].spheres.empty()
                                                  ? PlainModel::Diffuse
                                                  : PlainModel::None);
}

}  // namespace
}  // namespace candela
