#include "integrators/report/check_report.h"

#include <gtest/gtest.h>

#include "integrators/render.h"
#include "tests/image/crafted_files.h"
#include "tests/scenes/description.h"
#include "tests/scenes/exact_sphere.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

using namespace test;

std::string sentences(const description::SceneDescription& scene) {
  RenderOptions options;
  options.integrator = IntegratorKind::Report;
  const Diagnostics diagnostics = check_integrator(scene, options);
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics.list()) text += to_string(diagnostic) + "\n";
  return text;
}

TEST(Errors_ReportCheck, TheSmallRoomIsDrawn) {
  EXPECT_EQ(sentences(small_room()), "");
}

template <class Model>
std::string sentences_about(Model model) {
  description::SceneDescription scene = small_room();
  const auto material = add_material(scene, model);
  EXPECT_EQ(sentences(scene), "") << "nothing wears the material";
  scene.materials.back().span = {std::make_shared<std::string>("s.yaml"), 7, 3};
  scene.materials.back().name = "odd";
  add_mesh(scene, sphere({0, 0, 0}, 0.1, 1), material);
  return sentences(scene);
}

TEST(Errors_ReportCheck, DeltaLobesAreRefusedByName) {
  EXPECT_EQ(sentences_about(description::MirrorMaterial{}),
            "s.yaml:7:3: error: material 'odd' is a mirror, in which the report integrator would "
            "miss the lamps; expected diffuse, cook_torrance or a lab3 material\n");
  EXPECT_NE(sentences_about(description::DielectricMaterial{}).find("'odd' is a dielectric, in"),
            std::string::npos);
  EXPECT_NE(sentences_about(description::ConductorMaterial{}).find("'odd' is a conductor;"),
            std::string::npos);
  EXPECT_EQ(sentences_about(description::CookTorranceMaterial{}), "");
  EXPECT_EQ(sentences_about(description::LabMaterial{}), "");
}

TEST(Errors_ReportCheck, LightsWithoutAreaAreRefused) {
  description::SceneDescription scene = small_room();
  add_light(scene, description::PointLight{});
  add_light(scene, description::ConstantEnvironment{Vec3d(0.05), false});
  add_light(scene, description::ConstantEnvironment{Vec3d(0.0), false});  // black: no matter
  const Diagnostics diagnostics = check_report(scene);
  ASSERT_EQ(diagnostics.error_count(), 2u);
  EXPECT_NE(diagnostics.list()[0].message.find("the scene has a point light; the report"),
            std::string::npos);
  EXPECT_NE(diagnostics.list()[1].message.find("--ambient 0,0,0 takes it out"), std::string::npos);
}

TEST(Errors_ReportCheck, SpheresThatEmitAreRefused) {
  description::SceneDescription scene = small_room();
  add_mesh(scene, exact_sphere(0.1), add_material(scene, diffuse(Vec3d(0.5))));
  EXPECT_EQ(sentences(scene), "");
  add_mesh(scene, exact_sphere(0.1), add_material(scene, diffuse(Vec3d(0.0)), Vec3d(1.0)));
  EXPECT_EQ(sentences(scene),
            "error: this sphere emits; the report integrator knows lamps of triangles only\n");
}

TEST(Errors_ReportCheck, EmittersWithHolesAreRefused) {
  description::SceneDescription scene = small_room();
  const auto lamp = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(1.0));
  add_mesh(scene, sphere({0, 0, 0}, 0.1, 1), lamp);
  EXPECT_EQ(sentences(scene), "");
  scene.materials[lamp.index].name = "grid";
  scene.materials[lamp.index].opacity.factor = 0.5;
  EXPECT_EQ(sentences(scene),
            "error: material 'grid' emits and has holes (opacity); light samples of the report "
            "integrator would shine through them\n");
}

// lab3's materials have theirs by `d` and by the diffuse map.
TEST(Errors_ReportCheck, LabEmittersWithHolesAreRefused) {
  const TemporaryFolder folder;
  const auto holes_of = [](const description::LabMaterial& material,
                           std::vector<description::Image> images) {
    description::SceneDescription scene = small_room();
    scene.images = std::move(images);
    add_mesh(scene, sphere({0, 0, 0}, 0.1, 1), add_material(scene, material, Vec3d(1.0)));
    return sentences(scene).find("emits and has holes") != std::string::npos;
  };
  description::LabMaterial material{.diffuse = {Vec3d(0.0), {}, {}}};
  EXPECT_FALSE(holes_of(material, {}));
  material.alpha = 0.5;
  EXPECT_TRUE(holes_of(material, {}));
  material.alpha = 0.95;  // solid to the lab
  EXPECT_FALSE(holes_of(material, {}));
  material.diffuse.map = description::ImageHandle(0u);
  const auto half = [](int, int, int) { return 128u; };
  const auto image = [&](const std::string& name, const crafted::Bytes& bytes) {
    return description::Image{folder.put(name, bytes), Encoding::LabGamma, Wrap::Repeat, {}};
  };
  EXPECT_TRUE(holes_of(material, {image("rgba.png", crafted::png_rgba(2, 2, half))}));
  EXPECT_FALSE(
      holes_of(material, {image("rgb.png", crafted::png_of(2, 2, crafted::Rgb, 8, half))}));
}

TEST(Errors_ReportCheck, EmittersThatReflectAreWarnedOf) {
  description::SceneDescription scene = small_room();
  scene.materials[0].emission = Vec3d(1.0);
  const Diagnostics diagnostics = check_report(scene);
  EXPECT_FALSE(diagnostics.has_errors());
  ASSERT_EQ(diagnostics.warning_count(), 1u);
  EXPECT_NE(diagnostics.list()[0].message.find("emits and reflects"), std::string::npos);
}

}  // namespace
}  // namespace candela
