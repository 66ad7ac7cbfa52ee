#include "renderer/scene/compile.h"

#include <gtest/gtest.h>

#include "renderer/math/constants.h"
#include "tests/image/crafted_files.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

using namespace test;

std::uint64_t dropped_count(const Scene& scene, const std::string& what) {
  for (const Dropped& dropped : scene.dropped)
    if (dropped.what == what) return dropped.count;
  return 0;
}

description::SceneDescription one_quad() {
  description::SceneDescription scene;
  const auto material = add_material(scene, diffuse(Vec3d(0.5)));
  add_mesh(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), material);
  set_camera(scene, {0.5, 0.5, 3}, {0.5, 0.5, 0}, 40);
  return scene;
}

TEST(Unit_Compile, DropsWhatRaysCannotMeetAndCountsIt) {
  description::SceneDescription description = one_quad();
  description::Mesh& mesh = description.meshes[0];
  mesh.triangles.push_back({0, 1, 1});
  add_material(description, diffuse(Vec3d(0.1)));
  description.lights.push_back({{}, description::PointLight{{0, 0, 1}, Vec3d(0.0)}});
  description::SpotLight without_cone;
  without_cone.intensity = Vec3d(1.0);
  without_cone.inner_angle_radians = without_cone.outer_angle_radians = 0;
  description.lights.push_back({{}, without_cone});
  const Scene scene = compiled(description, {});
  ASSERT_EQ(scene.geometries.size(), 1u);
  EXPECT_EQ(scene.geometries[0].triangles.size(), 2u);
  EXPECT_EQ(scene.geometries[0].positions.size(), 4u);
  EXPECT_TRUE(scene.geometries[0].uvs.empty()) << "nothing reads them";
  EXPECT_EQ(dropped_count(scene, "triangles without area"), 1u);
  EXPECT_EQ(dropped_count(scene, "materials that nothing wears"), 1u);
  EXPECT_EQ(dropped_count(scene, "black lights"), 2u);
  EXPECT_TRUE(scene.lights.empty());
}

std::string only_warning(const description::SceneDescription& description) {
  const Result<Scene> scene = compile(description, {});
  EXPECT_TRUE(scene);
  const auto& list = scene.diagnostics.list();
  return list.size() == 1 ? list[0].message : fmt::format("{} of them", list.size());
}

TEST(Unit_Compile, WarnsWhereNoSurfaceIsLeft) {
  description::SceneDescription scene = one_quad();
  scene.lights.push_back({{}, description::PointLight{{0, 0, 1}, Vec3d(1.0)}});
  EXPECT_EQ(only_warning(scene), "0 of them");
  description::SceneDescription clear = scene;
  clear.materials[0].opacity.factor = 0;
  EXPECT_EQ(only_warning(clear),
            "all surfaces are left out (2 triangles that are wholly clear): there is nothing to "
            "see");
  description::SceneDescription flat = scene;
  for (Vec3d& position : flat.meshes[0].positions) position.y = 0;
  const std::string of_flat =
      "all surfaces are left out (2 triangles without area): there is nothing to see";
  EXPECT_EQ(only_warning(flat), of_flat);
  flat.lights[0].kind = description::ConstantEnvironment{Vec3d(1.0), false};
  EXPECT_EQ(only_warning(flat), of_flat);
  flat.lights[0].kind = description::ConstantEnvironment{Vec3d(1.0), true};
  EXPECT_EQ(only_warning(flat),
            "all surfaces are left out (2 triangles without area): there is the background alone");
}

// Not those that are needles as the file has them. The squares of the normal vanish, or one by one,
// or the edges do.
TEST(Unit_Compile, SaysWhichTrianglesAreTooSmall) {
  const auto expect_too_small = [](const Vec3d& at, const Vec3d& a, const Vec3d& b) {
    description::SceneDescription scene = one_quad();
    add_light(scene, description::PointLight{{0, 0, 1}, Vec3d(1.0)});
    const auto material = description::MaterialHandle(0);
    add_mesh(scene, triangle(at, at + a, at + b), material);
    add_mesh(scene, triangle(at, at + Vec3d(0.1, 0, 0), at + Vec3d(0.2, 0, 0)), material);
    EXPECT_EQ(only_warning(scene), "1 triangles that are too small beside the scene are left out");
    EXPECT_EQ(dropped_count(compiled(scene, {}), "triangles without area"), 1u);
  };
  const Vec3d middle(0.5, 0.5, 0);
  expect_too_small(middle, {1e-11, 0, 0}, {0, 1e-11, 0});
  expect_too_small(middle, {3.24e-10, -3.24e-10, 0}, {0, 3.24e-10, -3.24e-10});
  expect_too_small({0, 0.5, 0}, {1e-11, 0, 0}, {0, 1e-11, 0});
}

// Their transform squares lengths.
TEST(Unit_Compile, NormalsOfTinyAndHugeMeshesStay) {
  const auto normals_of = [](double size) {
    description::SceneDescription scene = one_quad();
    for (Vec3d& position : scene.meshes[0].positions) position *= size;
    scene.meshes[0].normals = {{0, 0, 1}, {1, 0, 1}, {0, 1, 2}, {0.1f, 0, 1}};
    scene.cameras[0].eye *= size;
    scene.cameras[0].target *= size;
    return compile(scene, {})->geometries[0].normals;
  };
  const std::vector<Vec3f> expected = normals_of(1);
  ASSERT_EQ(expected.size(), 4u);
  for (const double size : {0x1p-600, 0x1p-20, 0x1p600}) EXPECT_EQ(normals_of(size), expected);
}

// Further away nothing can be seen, and squares of floats end.
TEST(Errors_Compile, IntensitiesThatFloatsDoNotHold) {
  description::SceneDescription scene = small_room();
  add_light(scene, description::PointLight{{0, 0, 0}, Vec3d(1e300)});
  const Result<Scene> found = compile(scene, {});
  ASSERT_FALSE(found);
  EXPECT_NE(found.diagnostics.list()[0].message.find("more than numbers hold"), std::string::npos);
}

// They are not there to rays.
TEST(Unit_Compile, CoatsOfIndexOneAreSmooth) {
  for (const double ior : {1.0, 1.5}) {
    description::SceneDescription scene = small_room();
    scene.materials[0].model = description::CoatedDiffuseMaterial{
        {Vec3d(0.5), {}, {}}, {.ior = ior, .roughness = {0.3, {}, 0, {}}}};
    EXPECT_EQ(compiled(scene, {}).materials[0].roughness.constant, ior == 1 ? 0.0f : 0.3f);
  }
}

TEST(Errors_Compile, CamerasAgainstTheScenesSize) {
  const auto error_of = [](double size, auto&& spoil) {
    description::SceneDescription scene = one_quad();
    for (Vec3d& position : scene.meshes[0].positions) position *= size;
    description::Camera& camera = scene.cameras[0];
    camera.eye *= size;
    camera.target *= size;
    spoil(camera);
    const Result<Scene> compiled = compile(scene, {});
    return compiled ? "" : compiled.diagnostics.list().back().message;
  };
  for (const double size : {0x1p-600, 0x1p-50, 1.0, 0x1p600}) {
    EXPECT_EQ(error_of(size, [](auto&) {}), "") << size;
    EXPECT_EQ(error_of(size, [&](auto& camera) { camera.eye.z = 5e15 * size; }),
              "a camera is away from the scene by 5.0e+15 times the scene's size, expected at most "
              "1e+12");
    EXPECT_EQ(error_of(size, [&](auto& camera) { camera.lens_radius = 1e30 * size; }),
              "a camera has a lens whose radius is 1.0e+30 times the scene's size, expected at "
              "most 1e+12");
    EXPECT_EQ(error_of(size,
                       [&](auto& camera) {
                         camera.lens_radius = size;
                         camera.focus_distance = 1e-30 * size;
                       }),
              "a camera with a lens is focused at 1.0e-30 times the scene's size, expected at "
              "least 1e-12");
  }
  for (const double size : {0x1p-50, 1.0}) {
    EXPECT_EQ(error_of(size,
                       [&](auto& camera) {
                         camera.kind = description::CameraKind::Orthographic;
                         camera.screen_window = {-size, 1e18 * size, -size, size};
                       }),
              "a camera has a screen window that reaches to 1.0e+18 times the scene's size, "
              "expected at most 1e+12");
    EXPECT_EQ(error_of(size,
                       [&](auto& camera) {
                         camera.fovy_degrees = 90;
                         camera.screen_window = {-1, 1, -1e20, 1};
                       }),
              "a camera has a screen window that reaches to 1.0e+20 times its distance, expected "
              "at most 1e+12");
  }
}

TEST(Unit_Compile, TangentsAreForMaterialsThatReadThem) {
  const TemporaryFolder folder;
  const std::string path = folder.put("map.png", crafted::png_rgba(2, 2, [](int x, int y, int) {
                                        return static_cast<unsigned>(100 * x + 50 * y);
                                      }));
  description::SceneDescription scene = one_quad();
  scene.images.push_back({path, description::Encoding::Linear, description::Wrap::Repeat, {}});
  const description::ImageHandle map(0);
  const auto reads_tangents = [&](const description::MaterialHandle worn) {
    scene.meshes[0].materials = {worn};
    scene.meshes[0].uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    return compiled(scene, {}).geometries.at(0).reads_tangents;
  };
  const auto mapped = add_material(scene, description::DiffuseMaterial{{Vec3d(1.0), map}});
  const auto raised = add_material(scene, description::DiffuseMaterial{});
  scene.materials.back().height = map;
  const auto turned = add_material(scene, description::DiffuseMaterial{});
  scene.materials.back().normal_map = map;
  const auto mixed = add_material(scene, description::MixMaterial{mapped, raised});
  EXPECT_FALSE(reads_tangents(mapped));
  EXPECT_TRUE(reads_tangents(raised));
  EXPECT_TRUE(reads_tangents(turned));
  EXPECT_TRUE(reads_tangents(mixed)) << "its second part does";
}

TEST(Unit_Compile, SharedMeshesBecomeInstancesAndSingleOnesAreFlattened) {
  description::SceneDescription description = one_quad();
  Scene scene = compiled(description, {});
  EXPECT_EQ(scene.world.geometries.size(), 1u);
  EXPECT_TRUE(scene.instances.empty());
  for (int i = 0; i < 3; ++i) {
    description::Instance instance = description.instances[0];
    instance.object_to_world.translation = Vec3d(0, 0, -i - 1.0);
    description.instances.push_back(instance);
  }
  scene = compiled(description, {});
  EXPECT_TRUE(scene.world.geometries.empty());
  EXPECT_EQ(scene.objects.size(), 1u);
  EXPECT_EQ(scene.instances.size(), 4u);
}

// An instanced picture is the flattened one up to rounding.
TEST(Unit_Compile, InstancesLieWhereTheyShould) {
  description::SceneDescription description = one_quad();
  description.lights.push_back({{}, description::DirectionalLight{{0, 0, 1}, Vec3d(1.0)}});
  description::Instance other = description.instances[0];
  other.object_to_world.linear = Mat3d(Vec3d(-0.5, 0, 0), Vec3d(0, 0.25, 0.1), Vec3d(0, 0, 2));
  other.object_to_world.translation = Vec3d(1.5, 0.2, 0.5);
  description.instances.push_back(other);
  description::SceneDescription flat = description;
  flat.meshes.push_back(flat.meshes[0]);
  flat.instances[1].mesh = description::MeshHandle(1);
  const RenderSettings settings = settings_of(24, 4);
  const Image a = rendered(description, settings).film.to_image(true);
  const Image b = rendered(flat, settings).film.to_image(true);
  ASSERT_EQ(a.values.size(), b.values.size());
  int different = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    different += std::abs(a.values[i] - b.values[i]) > 1e-5f ? 1 : 0;
  EXPECT_LE(different, 8) << "at most an edge sample or two";
  EXPECT_GT(mean_of(a), 0.01);
}

// Two uses of a ball in the unit sphere, which a far triangle does not make smaller.
description::SceneDescription two_balls(const Mat3d& linear) {
  description::SceneDescription scene;
  const auto material = add_material(scene, diffuse(Vec3d(0.5)));
  add_mesh(scene, sphere({0, 0, 0}, 1, 4), material);
  const auto ball = add_mesh(scene, sphere({0, 0, 0}, 1, 1), material, {linear, {0, 2, 0}});
  add_instance(scene, ball, {2.0 * linear, {0, 0, 0}});
  add_light(scene, description::ConstantEnvironment{Vec3d(1.0), true});
  set_camera(scene, {0, 0, 5}, {0, 0, 0}, 60);
  return scene;
}

// Else one accelerator aborts the process, or the two disagree.
TEST(Unit_Compile, InstancesBeyondFloatsAreFlattened) {
  const std::size_t triangles = sphere({0, 0, 0}, 1, 1).triangles.size();
  EXPECT_EQ(compiled(two_balls(Mat3d(1e-3)), {}).instances.size(), 2u);
  for (const Vec3d& size : {Vec3d(1, 1, 1e-19), Vec3d(1, 1e-13, 1e-13)}) {
    const auto description = two_balls(Mat3d({size.x, 0, 0}, {0, size.y, 0}, {0, 0, size.z}));
    const Scene scene = compiled(description, {});
    EXPECT_TRUE(scene.instances.empty());
    EXPECT_EQ(dropped_count(scene, "instances that only their triangles can be placed of"), 2u);
    RenderSettings settings = settings_of(16, 4);
    settings.accelerator = AcceleratorKind::Embree;
    const Image a = rendered(description, settings).film.to_image(true);
    settings.accelerator = AcceleratorKind::Bvh;
    const Image b = rendered(description, settings).film.to_image(true);
    EXPECT_NEAR(mean_of(a), mean_of(b), 2e-3) << "a sample or two at edges";
  }
  // Rays that start on the far triangle would leave floats in the small balls' own space.
  description::SceneDescription far = two_balls(Mat3d(1e-5));
  EXPECT_EQ(compiled(far, {}).instances.size(), 2u);
  add_mesh(far, triangle({1e14, 0, 0}, {1e14, 1e10, 0}, {1e14, 0, 1e10}),
           description::MaterialHandle(0));
  const Scene scene = compiled(far, {});
  EXPECT_TRUE(scene.instances.empty());
  ASSERT_EQ(scene.world.geometries.size(), 4u);
  EXPECT_EQ(scene.geometries[2].triangles.size(), triangles);
}

// So that they are cut where they come near the scene: floats of an object's own space end there.
TEST(Unit_Compile, InstancesOfHugeGroundsAreFlattened) {
  description::SceneDescription scene = two_balls(Mat3d(0.5));
  const auto ground = add_mesh(scene, quad({-1, 0, -1}, {0, 0, 2}, {2, 0, 0}),
                               description::MaterialHandle(0), {Mat3d(1e6), {0, -1, 0}});
  add_instance(scene, ground, {Mat3d(1e6), {0, -1000, 0}});
  const Scene compiled_scene = compiled(scene, {});
  EXPECT_EQ(compiled_scene.instances.size(), 2u) << "the balls";
  ASSERT_EQ(compiled_scene.world.geometries.size(), 3u);
  const std::uint32_t last = compiled_scene.world.geometries.back().index;
  EXPECT_GT(compiled_scene.geometries[last].triangles.size(), 50u);
}

TEST(Unit_Compile, TooManyTrianglesOfInstancesBeyondFloatsAreLeftOutAndSaid) {
  description::SceneDescription scene = one_quad();
  add_light(scene, description::PointLight{{0, 0, 1}, Vec3d(1.0)});
  scene.meshes.push_back(scene.meshes[0]);
  scene.meshes[1].triangles.resize(std::size_t{1} << 20, {0, 1, 2});
  const Transform thin{Mat3d({1, 0, 0}, {0, 1, 0}, {0, 0, 1e-19}), {0, 0, 0}};
  scene.instances.push_back(scene.instances[0]);
  scene.instances[1].mesh = description::MeshHandle(1);
  scene.instances[1].object_to_world = thin;
  scene.instances.push_back(scene.instances[1]);
  EXPECT_EQ(only_warning(scene), "1 instances that are too small or too large are left out");
}

// A brushed metal under an even coat, too.
TEST(Unit_Compile, FramesFollowTangentsWhereALobeHasTwoWidths) {
  const auto follows = [](const description::CoatedConductorMaterial& metal) {
    description::SceneDescription scene = one_quad();
    scene.materials[0].model = metal;
    const Scene out = compiled(scene, {});
    EXPECT_EQ(out.materials[0].follows_tangents, out.materials[0].reads_tangents);
    return out.materials[0].follows_tangents;
  };
  description::CoatedConductorMaterial metal;
  metal.roughness.factor = 0.4;
  EXPECT_FALSE(follows(metal));
  metal.roughness_across = description::ScalarInput{0.4, {}, 0, {}};
  EXPECT_FALSE(follows(metal));
  metal.roughness_across->factor = 0.05;
  EXPECT_TRUE(follows(metal));
  metal.roughness_across.reset();
  metal.coat.roughness_across = description::ScalarInput{0.3, {}, 0, {}};
  EXPECT_TRUE(follows(metal));
}

TEST(Unit_Compile, EmissiveInstancesAreFlattenedIntoLights) {
  description::SceneDescription description = one_quad();
  description.materials[0].emission = Vec3d(2.0);
  description.instances.push_back(description.instances[0]);
  description.instances[1].object_to_world.translation = Vec3d(0, 0, -1);
  RenderOptions options;
  options.light_sampling = LightSampling::Triangles;
  const Scene scene = compiled(description, options);
  EXPECT_EQ(scene.lights.size(), 4u);
  EXPECT_TRUE(scene.instances.empty());
  double area = 0;
  for (const Light& light : scene.lights) area += static_cast<double>(light.area);
  EXPECT_NEAR(area / square(scene.normalisation.scale), 2.0, 1e-5);
}

TEST(Unit_Compile, WindingsFollowVertexNormals) {
  description::SceneDescription description = one_quad();
  description.meshes[0].normals.assign(4, Vec3f(0, 0, -1));
  const Scene scene = compiled(description, {});
  const Geometry& geometry = scene.geometries[0];
  const auto& t = geometry.triangles[0];
  const Vec3f n = cross(geometry.positions[t[1]] - geometry.positions[t[0]],
                        geometry.positions[t[2]] - geometry.positions[t[0]]);
  EXPECT_LT(n.z, 0);
}

TEST(Unit_Compile, DropsNormalsThatSayWhatTheWindingSays) {
  description::SceneDescription description = one_quad();
  description.meshes[0].normals.assign(4, Vec3f(0, 0, -2));
  EXPECT_TRUE(compiled(description, {}).geometries[0].normals.empty());
  description.meshes[0].normals[2] = Vec3f(1e-4f, 0, -2);
  EXPECT_EQ(compiled(description, {}).geometries[0].normals.size(), 4u);
}

TEST(Unit_Compile, TriangleLightsBecomeSurfacesThatEmit) {
  description::SceneDescription description = one_quad();
  description.lights.push_back(
      {{},
       description::TriangleLight{
           {Vec3d(0, 0, 2), Vec3d(0, 1, 2), Vec3d(1, 0, 2)}, Vec3d(3.0), false}});
  const Scene scene = compiled(description, {});
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].kind, LightKind::Triangle);
  EXPECT_EQ(scene.lights[0].emission, Rgb(3));
  EXPECT_TRUE(scene.geometries[scene.lights[0].geometry].is_emissive());
}

TEST(Unit_Compile, PointLightsKeepTheirIrradianceInNormalisedSpace) {
  description::SceneDescription description = one_quad();
  description.lights.push_back({{}, description::PointLight{{0.5, 0.5, 10}, Vec3d(7.0)}});
  const Scene scene = compiled(description, {});
  const float distance = scene.lights[0].position.z - (scene.bounds.lower.z);
  EXPECT_NEAR(scene.lights[0].emission.x / square(distance), 7.0 / 100, 1e-6);
}

TEST(Unit_Compile, LabColoursAreDecodedAndQuantisedOnRequest) {
  description::SceneDescription description = one_quad();
  description::LabMaterial lab;
  lab.diffuse.factor = Vec3d(0.5, 0.2, 1.0);
  lab.specular.factor = Vec3d(0.3);
  lab.shininess = 32;
  description.materials[0].model = lab;
  Scene scene = compiled(description, {});
  EXPECT_EQ(scene.materials[0].model, MaterialModel::Lab);
  EXPECT_NEAR(scene.materials[0].diffuse.constant.x, std::pow(0.5, 2.2), 1e-6);
  EXPECT_NEAR(scene.materials[0].roughness.constant, std::sqrt(2.0 / 34.0), 1e-6);
  const Result<Scene> quantised = compile(description, {512, 512, true});
  ASSERT_TRUE(quantised);
  EXPECT_NEAR(quantised->materials[0].diffuse.constant.x, std::pow(128 / 255.0, 2.2), 1e-6);
  EXPECT_NEAR(quantised->materials[0].shininess, 32.0 / 255 * 256, 1e-4);
}

}  // namespace
}  // namespace candela
