#include "renderer/description/validate.h"

#include <limits>

#include <gtest/gtest.h>

#include "renderer/math/constants.h"
#include "tests/scenes/description.h"
#include "tests/scenes/exact_sphere.h"

namespace candela {
namespace {

using description::lint;
using description::validate;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> messages(const Diagnostics& diagnostics, Severity severity) {
  std::vector<std::string> found;
  for (const Diagnostic& diagnostic : diagnostics.list())
    if (diagnostic.severity == severity) found.push_back(diagnostic.message);
  return found;
}

// `spoil` breaks a good scene; what validate() then says, if it says one thing.
template <class Spoil>
std::string error_after(Spoil&& spoil) {
  description::SceneDescription scene = test::small_room();
  spoil(scene);
  const auto errors = messages(validate(scene), Severity::Error);
  return errors.size() == 1 ? errors[0] : fmt::format("{} errors", errors.size());
}

template <class Kind>
std::string error_of_light(Kind kind) {
  return error_after([&](auto& scene) { test::add_light(scene, kind); });
}

template <class Model>
std::string error_of_material(Model model) {
  return error_after([&](auto& scene) { test::add_material(scene, model); });
}

TEST(Unit_Validate, HasNothingToSayAboutAGoodScene) {
  EXPECT_TRUE(validate(test::small_room()).list().empty());
  EXPECT_TRUE(lint(test::small_room()).list().empty());
}

TEST(Errors_Validate, Meshes) {
  EXPECT_NE(error_after([](auto& scene) {
              scene.meshes[0].name = "a";
              scene.meshes[0].triangles[1] = {0, 1, 4000};
            }).find("mesh 'a': triangle 1 uses vertex 4000 of "),
            std::string::npos);
  EXPECT_NE(error_after([](auto& scene) {
              scene.meshes[0].positions[2].y = not_a_number;
            }).find("have numbers that are not finite, the first is number 3"),
            std::string::npos);
  EXPECT_NE(error_after([](auto& scene) {
              scene.meshes[0].uvs.assign(2, Vec2f(0));
            }).find("has 2 texture coordinates for "),
            std::string::npos);
  EXPECT_NE(error_after([](auto& scene) {
              scene.meshes[0].normals.assign(1, Vec3f(0));
            }).find("has 1 normals for "),
            std::string::npos);
  EXPECT_NE(error_after([](auto& scene) {
              scene.meshes[0].materials = {description::MaterialHandle(99)};
            }).find("has a material that does not exist"),
            std::string::npos);
  EXPECT_NE(error_after([](auto& scene) {
              scene.meshes[0].materials.clear();
            }).find("has 0 materials for "),
            std::string::npos);
}

TEST(Errors_Validate, Instances) {
  EXPECT_EQ(error_after([](auto& scene) { scene.instances[0].mesh = description::MeshHandle(77); }),
            "an instance of a mesh that does not exist");
  EXPECT_EQ(error_after([](auto& scene) {
              scene.instances[0].material_override = description::MaterialHandle(77);
            }),
            "an instance has a material that does not exist");
  EXPECT_EQ(error_after([](auto& scene) {
              scene.instances[0].object_to_world.translation.x = not_a_number;
            }),
            "the transform of an instance has numbers that are not finite");
  EXPECT_EQ(
      error_after([](auto& scene) { scene.instances[0].object_to_world.linear[1] = Vec3d(0.0); }),
      "the transform of an instance is singular: it flattens it");
  EXPECT_EQ(error_after([](auto& scene) {
              Mat3d& linear = scene.instances[0].object_to_world.linear;
              linear[1] = linear[0] * 3.0;
            }),
            "the transform of an instance is singular: it flattens it");
}

TEST(Unit_Validate, AcceptsTransformsOfAnySize) {
  for (const double scale : {1e-100, 1e-12, 1e12, 1e30}) {
    description::SceneDescription scene = test::small_room();
    scene.instances[0].object_to_world.linear = Mat3d(scale);
    EXPECT_FALSE(validate(scene).has_errors()) << scale;
  }
}

TEST(Errors_Validate, LabsAmbientLight) {
  EXPECT_EQ(error_after([](auto& scene) { scene.lab_ambient = Vec3d(0.1, -1, 0.1); }),
            "the ambient light is -1, expected 0 to 1e+30");
}

TEST(Errors_Validate, InputsByAMapAndATexture) {
  const std::string found = error_after([](auto& scene) {
    scene.images.push_back({"a.png", {}, {}, {}});
    scene.textures.push_back({"t", {}, description::CheckerboardTexture{}});
    scene.materials[0].model = description::DiffuseMaterial{
        {Vec3d(1.0), description::ImageHandle(0), description::TextureHandle(0)}};
  });
  EXPECT_NE(found.find("the reflectance has a map and a texture"), std::string::npos) << found;
  const std::string heights = error_after([](auto& scene) {
    scene.images.push_back({"a.png", {}, {}, {}});
    scene.textures.push_back({"t", {}, description::CheckerboardTexture{}});
    scene.materials[0].height = description::ImageHandle(0);
    scene.materials[0].height_texture = description::TextureHandle(0);
  });
  EXPECT_NE(heights.find("heights have a map and a texture"), std::string::npos) << heights;
}

TEST(Errors_Validate, Lights) {
  EXPECT_EQ(error_of_light(description::PointLight{{0, not_a_number, 0}, Vec3d(1)}),
            "the position of a light is not finite");
  EXPECT_EQ(error_of_light(description::PointLight{{0, 0, 0}, Vec3d(1, -2, 1)}),
            "the intensity of a light is -2, expected finite numbers of at least 0");
  EXPECT_EQ(error_of_light(description::DirectionalLight{{0, 2, 0}, Vec3d(1)}),
            "the direction of a light is not of length 1");
  EXPECT_EQ(error_of_light(description::DirectionalLight{{0, not_a_number, 0}, Vec3d(1)}),
            "the direction of a light is not of length 1");
  EXPECT_EQ(
      error_of_light(description::TriangleLight{{Vec3d(0), Vec3d(1), Vec3d(2)}, Vec3d(1), false}),
      "a triangle light has no area");
  EXPECT_EQ(error_of_light(description::LatLongEnvironment{}),
            "the image of a light does not exist");
  EXPECT_EQ(error_of_light(description::SpotLight{Vec3d(0), Vec3d(0, -1, 0), Vec3d(1), 0.5, 0.25}),
            "the half angles of a spot light are 0.5 and 0.25, expected 0 <= inner <= outer <= pi");
  EXPECT_EQ(error_after([](auto& scene) {
              test::add_light(scene, description::ConstantEnvironment{Vec3d(1.0), true});
              test::add_light(scene, description::ConstantEnvironment{Vec3d(0.0), false});
              test::add_light(scene, description::ConstantEnvironment{Vec3d(2.0), false});
            }),
            "this environment is not seen by cameras, unlike the first: several are added up, "
            "expected all to be seen or none");
}

TEST(Errors_Validate, Materials) {
  description::CookTorranceMaterial rough;
  rough.diffuse.factor.y = -0.5;
  EXPECT_NE(error_of_material(rough).find("kd is -0.5, expected 0 to 1"), std::string::npos);
  rough = {};
  rough.roughness.factor = 1.5;
  EXPECT_NE(error_of_material(rough).find("the roughness is 1.5, expected 0 to 1"),
            std::string::npos);
  rough = {};
  rough.fresnel = description::FresnelModel::Exact;
  EXPECT_NE(error_of_material(rough).find("the exact Fresnel term needs a refractive index"),
            std::string::npos);
  description::DielectricMaterial glass;
  glass.ior = not_a_number;
  EXPECT_NE(error_of_material(glass).find("the refractive index is nan, expected 0.1 to 1000"),
            std::string::npos);
  glass.ior = 1e20;
  EXPECT_NE(error_of_material(glass).find("the refractive index is 1e+20, expected 0.1 to 1000"),
            std::string::npos);
  description::CoatedDiffuseMaterial coated;
  coated.coat.max_depth = 2'000'000'000;
  EXPECT_NE(error_of_material(coated).find("the depth of the coat is 2000000000, expected 0 to"),
            std::string::npos);
  EXPECT_NE(
      error_of_material(description::DiffuseMaterial{{Vec3d(0.5), description::ImageHandle(5)}})
          .find("the map of the reflectance does not exist"),
      std::string::npos);
  EXPECT_NE(error_after([](auto& scene) {
              scene.materials[0].emission = Vec3d(0, -1, 0);
            }).find("the emission is -1, expected at least 0"),
            std::string::npos);
}

TEST(Errors_Validate, Cameras) {
  EXPECT_EQ(error_after([](auto& scene) { scene.cameras.clear(); }), "the scene has no camera");
  EXPECT_EQ(error_after([](auto& scene) { scene.cameras[0].target = scene.cameras[0].eye; }),
            "a camera's eye and target are the same point");
  EXPECT_EQ(error_after([](auto& scene) {
              scene.cameras[0].up = scene.cameras[0].eye - scene.cameras[0].target;
            }),
            "a camera's up direction is parallel to its line of sight");
  EXPECT_EQ(error_after([](auto& scene) { scene.cameras[0].fovy_degrees = 180; }),
            "a camera's vertical angle of view is 180 degrees, expected above 0 and below 180");
  EXPECT_EQ(error_after([](auto& scene) { scene.cameras[0].lens_radius = -1; }),
            "a camera's lens radius is -1, expected at least 0");
}

TEST(Unit_Validate, Spheres) {
  const auto error_of = [](const description::Mesh& mesh, const Transform& placement) {
    description::SceneDescription scene = test::small_room();
    test::add_mesh(scene, mesh, description::MaterialHandle(0), placement);
    const auto errors = messages(validate(scene), Severity::Error);
    return errors.empty() ? "" : errors[0];
  };
  const Transform turned{2.0 * Mat3d(0.6, 0.8, 0, 0.8, -0.6, 0, 0, 0, 1), Vec3d(1.0)};  // mirrored
  EXPECT_EQ(error_of(test::exact_sphere(2), turned), "");
  EXPECT_EQ(error_of(test::exact_sphere(0), {}),
            "mesh 'sphere' is a sphere of radius 0, expected above 0");
  EXPECT_EQ(error_of(test::exact_sphere(1), {Mat3d(1, 0, 0, 0, 1.01, 0, 0, 0, 1), Vec3d(0.0)}),
            "the transform of a sphere stretches or shears it, expected one that turns, moves, "
            "mirrors and enlarges only");
  description::Mesh both = test::exact_sphere(1);
  both.positions = {{0, 0, 0}};
  EXPECT_EQ(error_of(both, {}), "mesh 'sphere' is a sphere and has vertices or triangles");
}

TEST(Unit_Validate, RadianceIsLimited) {
  const auto error_of = [](const auto& change) {
    description::SceneDescription scene = test::small_room();
    change(scene);
    const auto errors = messages(validate(scene), Severity::Error);
    return errors.size() == 1 ? errors[0] : "";
  };
  const Vec3d most(description::largest_radiance);
  const Vec3d more(1, 2e30, 1);
  for (const bool is_more : {false, true}) {
    const Vec3d light = is_more ? more : most;
    EXPECT_EQ(error_of([&](auto& scene) {
                test::add_light(scene, description::ConstantEnvironment{light});
              }),
              is_more ? "the radiance of a light is 2e+30, expected at most 1e+30" : "");
    EXPECT_EQ(error_of([&](auto& scene) {
                test::add_light(scene, description::DirectionalLight{{0, 0, 1}, light});
              }),
              is_more ? "the irradiance of a light is 2e+30, expected at most 1e+30" : "");
    EXPECT_EQ(error_of([&](auto& scene) {
                scene.materials[0].name = "sun";
                scene.materials[0].emission = light;
              }),
              is_more ? "material 'sun': the emission is 2e+30, expected at most 1e+30" : "");
  }
}

TEST(Unit_Validate, WarnsOfScenesWithNothingInThem) {
  description::SceneDescription scene = test::empty_scene();
  test::set_camera(scene, {0, 0, 5}, {0, 0, 0});
  const auto warnings = messages(validate(scene), Severity::Warning);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0], "the scene has no surface: there is nothing to see");
  EXPECT_EQ(warnings[1], "the scene has no light: the picture will be black");
}

TEST(Unit_Validate, TriangleLightsAreThereToBeSeen) {
  description::SceneDescription scene = test::empty_scene();
  test::set_camera(scene, {0, 0, 5}, {0, 0, 0});
  test::add_light(scene, description::TriangleLight{
                             {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0)}, Vec3d(1.0)});
  EXPECT_EQ(messages(validate(scene), Severity::Warning), std::vector<std::string>{});
}

TEST(Errors_Validate, MixturesOfMixturesAreNotEndless) {
  description::SceneDescription scene = test::small_room();
  description::MixMaterial mix;
  mix.first = mix.second = description::MaterialHandle(0u);
  for (int depth = 1; depth <= 17; ++depth) {
    test::add_material(scene, mix);
    scene.materials.back().name = "mix" + std::to_string(depth);
    mix.first = mix.second = description::MaterialHandle(scene.materials.size() - 1);
    const auto expected = depth <= 16 ? std::vector<std::string>{}
                                      : std::vector<std::string>{
                                            "material 'mix17': mixtures of "
                                            "mixtures more than 16 deep"};
    EXPECT_EQ(messages(validate(scene), Severity::Error), expected) << depth;
  }
}

TEST(Errors_Validate, WaysToReadImagesThatThereAreNot) {
  const auto error_of = [](description::Encoding encoding, description::Wrap wrap) {
    return error_after([&](auto& scene) { scene.images.push_back({"a.png", encoding, wrap, {}}); });
  };
  const std::string expected = "an image of an encoding or a wrap that there is not";
  EXPECT_EQ(error_of(description::Encoding(77), description::Wrap::Clamp), expected);
  EXPECT_EQ(error_of(description::Encoding::Srgb, description::Wrap(4)), expected);
}

// Skies and media are seen without any surface.
TEST(Unit_Validate, SkiesAndFogAreThereToBeSeen) {
  description::SceneDescription sky = test::empty_scene();
  test::set_camera(sky, {0, 0, 5}, {0, 0, 0});
  sky.lights.push_back({{}, description::ConstantEnvironment{Vec3d(1.0)}});
  EXPECT_TRUE(messages(validate(sky), Severity::Warning).empty());
  std::get<description::ConstantEnvironment>(sky.lights[0].kind).is_seen_by_camera = false;
  EXPECT_EQ(messages(validate(sky), Severity::Warning).size(), 1u);
  sky.media.emplace_back();
  sky.cameras[0].medium = description::MediumHandle(std::size_t{0});
  EXPECT_EQ(messages(validate(sky), Severity::Warning).size(), 1u);  // it is as clear as none
  sky.media[0].scattering = Vec3d(0.1);
  EXPECT_TRUE(messages(validate(sky), Severity::Warning).empty());
}

TEST(Unit_Validate, WarnsOfReflectancesThatAddUpToMoreThanOne) {
  description::SceneDescription scene = test::small_room();
  description::CookTorranceMaterial rough;
  rough.specular.factor = Vec3d(0.75);
  test::add_material(scene, rough);
  scene.materials.back().name = "metal";
  const auto warnings = messages(validate(scene), Severity::Warning);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(
      warnings[0],
      "material 'metal': kd + ks reaches 1.25 in a channel, more than 1: both are scaled down "
      "there");
  // Factors of textures tell nothing.
  scene.textures.push_back({"checks", {}, description::CheckerboardTexture{}});
  std::get<description::CookTorranceMaterial>(scene.materials.back().model).diffuse.texture =
      description::TextureHandle(0);
  EXPECT_TRUE(messages(validate(scene), Severity::Warning).empty());
}

TEST(Unit_Validate, EnergyCompensationNeedsSmithsGeometry) {
  description::SceneDescription scene = test::small_room();
  description::CookTorranceMaterial rough;
  rough.energy_compensation = true;
  test::add_material(scene, rough);
  scene.materials.back().name = "metal";
  const auto errors = messages(validate(scene), Severity::Error);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0], "material 'metal': energy compensation needs Smith's geometry");
}

TEST(Unit_Validate, EnergyCompensationNeedsOneRoughness) {
  description::SceneDescription scene = test::small_room();
  description::ConductorMaterial metal;
  metal.roughness.factor = 0.2;
  metal.energy_compensation = true;
  test::add_material(scene, metal);
  scene.materials.back().name = "metal";
  EXPECT_TRUE(messages(validate(scene), Severity::Error).empty());
  metal.roughness_across = description::ScalarInput{0.4, {}, 0};
  scene.materials.back().model = metal;
  EXPECT_EQ(messages(validate(scene), Severity::Error),
            std::vector<std::string>{
                "material 'metal': energy compensation needs one roughness, not another across"});
}

TEST(Unit_Lint, FindsWhatIsProbablyNotMeant) {
  description::SceneDescription scene = test::small_room();
  scene.path = "room.yaml";
  test::add_material(scene, description::DiffuseMaterial{});
  scene.materials.back().name = "spare";
  scene.materials.back().span.file = std::make_shared<const std::string>("room.yaml");
  test::add_light(scene, description::PointLight{{0, 0, 0}, Vec3d(0)});
  description::Camera turned_away;
  turned_away.eye = {0, 0, 50};
  turned_away.target = {0, 0, 60};
  scene.cameras.push_back(turned_away);
  const auto warnings = messages(lint(scene), Severity::Warning);
  ASSERT_EQ(warnings.size(), 3u);
  EXPECT_EQ(warnings[0], "material 'spare' is used by no model");
  EXPECT_EQ(warnings[1], "this light is black");
  EXPECT_EQ(warnings[2], "all of the scene lies behind this camera");
}

// Whatever its unit.
TEST(Unit_Lint, CamerasSeeScenesOfAnySize) {
  for (const double size : {1e-300, 1e-160, 1e150, 1e300}) {
    description::SceneDescription scene;
    test::add_mesh(scene, test::quad({-size, -size, 0}, {2 * size, 0, 0}, {0, 2 * size, 0}),
                   test::add_material(scene, description::DiffuseMaterial{}));
    description::Camera camera;
    camera.eye = {0, 0, 4 * size};
    camera.target = {0, 0, 0};
    scene.cameras.push_back(camera);
    EXPECT_TRUE(messages(lint(scene), Severity::Warning).empty()) << size;
  }
}

TEST(Unit_Lint, LeavesUnusedMaterialsOfLibrariesAlone) {
  description::SceneDescription scene = test::small_room();
  scene.path = "room.yaml";
  test::add_material(scene, description::DiffuseMaterial{});
  scene.materials.back().span.file = std::make_shared<const std::string>("room.mtl");
  EXPECT_TRUE(lint(scene).list().empty());
}

}  // namespace
}  // namespace candela
