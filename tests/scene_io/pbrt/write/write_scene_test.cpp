// Cameras, film and lights come back as they were.
#include <gtest/gtest.h>

#include "scene_io/pbrt/write/write_pbrt.h"
#include "tests/scene_io/pbrt/pbrt_text.h"
#include "tests/scene_io/pbrt/write/round_trip.h"
#include "tests/scenes/description.h"

namespace candela::pbrt {
namespace {

using namespace description;
using test::RoundTrip;

constexpr double rounding = 1e-14;
const Vec3d odd(0.1, 1.0 / 3, 0.7);

SceneDescription room() {
  SceneDescription scene = test::small_room();
  scene.defaults.width = 40;
  scene.defaults.height = 30;
  return scene;
}

void expect_near(const Vec3d& a, const Vec3d& b, double tolerance = rounding) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance * (1 + std::abs(b[c])));
}

Camera camera_back(const Camera& camera) {
  SceneDescription scene = room();
  scene.cameras = {camera};
  const RoundTrip trip = test::round_trip(scene);
  return trip.scene.cameras.empty() ? Camera{} : trip.scene.cameras[0];
}

Camera odd_camera(CameraKind kind, bool is_mirrored) {
  Camera camera;
  camera.kind = kind;
  camera.eye = {1, 2, 3};
  camera.target = {0.5, -1, 1};
  camera.up = {0.1, 1, 0.2};
  camera.is_mirrored = is_mirrored;
  camera.fovy_degrees = 37.5;
  return camera;
}

// The frame of Camera, as compile_camera() makes it.
void expect_same_frame(const Camera& a, const Camera& b) {
  expect_near(a.eye, b.eye);
  const auto frame = [](const Camera& c) {
    const Vec3d look = normalize(c.target - c.eye);
    const Vec3d right = normalize(cross(look, c.up));
    return Mat3d(right, cross(right, look), look);
  };
  for (int c = 0; c < 3; ++c) expect_near(frame(a)[c], frame(b)[c]);
  EXPECT_EQ(a.is_mirrored, b.is_mirrored);
}

TEST(Unit_WriteView, CamerasOfAllKinds) {
  for (const CameraKind kind : {CameraKind::Perspective, CameraKind::Orthographic,
                                CameraKind::LatLong, CameraKind::EqualArea})
    for (const bool is_mirrored : {false, true}) {
      SCOPED_TRACE(testing::Message() << "kind " << static_cast<int>(kind) << is_mirrored);
      const Camera camera = odd_camera(kind, is_mirrored);
      const Camera back = camera_back(camera);
      EXPECT_EQ(back.kind, kind);
      expect_same_frame(back, camera);
    }
}

TEST(Unit_WriteView, OneOfSeveralCameras) {
  SceneDescription scene = room();
  scene.cameras = {odd_camera(CameraKind::Perspective, false),
                   odd_camera(CameraKind::Orthographic, true)};
  scene.cameras[1].eye = {-3, 0.5, 2};
  scene.cameras[1].medium = test::add_medium(scene, Vec3d(0.1), Vec3d(0.2));
  for (const std::size_t camera : {0, 1}) {
    const auto written = write_pbrt(scene, {"files", "picture.exr", camera, {}});
    ASSERT_TRUE(written);
    EXPECT_EQ(written->text.find("MediumInterface") != std::string::npos, camera == 1);
    scene.cameras[1 - camera].eye.z += 1;  // of no interest to it
    EXPECT_EQ(write_pbrt(scene, {"files", "picture.exr", camera, {}})->text, written->text);
    scene.cameras[camera].eye.z += 1;
    EXPECT_NE(write_pbrt(scene, {"files", "picture.exr", camera, {}})->text, written->text);
  }
}

TEST(Unit_WriteView, SeedsThatPbrtCannotHold) {
  SceneDescription scene = room();
  for (const std::uint64_t seed : {std::uint64_t{1} << 31, ~std::uint64_t{0}}) {
    scene.defaults.seed = seed;
    EXPECT_EQ(test::round_trip(scene).scene.defaults.seed, seed);
  }
}

// The file says nothing of the picture's aspect.
TEST(Unit_WriteView, OrthographicCamerasThatFollowThePicture) {
  Camera camera = odd_camera(CameraKind::Orthographic, true);
  camera.fov_is_of_shorter_side = true;
  EXPECT_FALSE(camera_back(camera).screen_window);
}

TEST(Unit_WriteView, AnglesLensesAndWindows) {
  Camera camera = odd_camera(CameraKind::Perspective, false);
  camera.lens_radius = 0.125;
  Camera back = camera_back(camera);
  EXPECT_EQ(back.fovy_degrees, 37.5);
  EXPECT_FALSE(back.fov_is_of_shorter_side);
  EXPECT_NEAR(back.lens_radius, 0.125, rounding);
  EXPECT_NEAR(back.focus_distance, length(camera.target - camera.eye), rounding * 10);
  camera.fov_is_of_shorter_side = true;
  camera.screen_window = ScreenWindow{-2, 1.5, -0.25, 0.75};
  camera.focus_distance = 7;
  back = camera_back(camera);
  EXPECT_TRUE(back.fov_is_of_shorter_side);
  EXPECT_NEAR(back.focus_distance, 7, rounding * 10);
  ASSERT_TRUE(back.screen_window);
  EXPECT_EQ(back.screen_window->left, -2);
  EXPECT_EQ(back.screen_window->right, 1.5);
  EXPECT_EQ(back.screen_window->bottom, -0.25);
  EXPECT_EQ(back.screen_window->top, 0.75);
}

// pbrt's angle is of the shorter side: of a tall picture that is the width.
TEST(Unit_WriteView, TallPicturesHaveTheirWidthsAngle) {
  SceneDescription scene = room();
  scene.cameras[0].fovy_degrees = 90;
  scene.defaults.width = 10;
  scene.defaults.height = 20;
  const std::string text = test::round_trip(scene).written.text;
  const std::size_t at = text.find("\"float fov\" ");
  ASSERT_NE(at, std::string::npos);
  EXPECT_NEAR(std::stod(text.substr(at + 12)), 2 * std::atan(0.5) * 180 / 3.14159265358979, 1e-9);
}

TEST(Unit_WriteView, WhatTheSceneAsksFor) {
  SceneDescription scene = room();
  auto& defaults = scene.defaults;
  defaults.samples_per_pixel = 49;
  defaults.seed = 12345;
  defaults.filter = "blackman_harris";
  defaults.white_balance_kelvins = 5003.25;
  defaults.filter_radius = 1.75;
  defaults.integrator = "whitted";
  defaults.exposure = -1.5;
  defaults.crop = CropWindow{0.125, 0.5, 0.25, 1};
  scene.lab_ambient = Vec3d(0.1, 0.2, 0.3);
  RenderDefaults back = test::round_trip(scene).scene.defaults;
  EXPECT_EQ(back.width, 40);
  EXPECT_EQ(back.height, 30);
  EXPECT_EQ(back.samples_per_pixel, 49);
  EXPECT_EQ(back.seed, 12345u);
  EXPECT_EQ(back.filter, "blackman_harris");
  EXPECT_EQ(back.filter_radius, 1.75);
  EXPECT_EQ(back.integrator, "whitted");
  EXPECT_EQ(back.exposure, -1.5);
  EXPECT_EQ(back.white_balance_kelvins, 5003.25);
  ASSERT_TRUE(back.crop);
  EXPECT_EQ(back.crop->left, 0.125);
  EXPECT_EQ(back.crop->right, 0.5);
  EXPECT_EQ(back.crop->top, 0.25);
  EXPECT_EQ(back.crop->bottom, 1);
  EXPECT_EQ(back.max_depth, std::nullopt);
  EXPECT_EQ(test::round_trip(scene).scene.lab_ambient, scene.lab_ambient);
  defaults.filter = "triangle";
  defaults.max_depth = 7;
  back = test::round_trip(scene).scene.defaults;
  EXPECT_EQ(back.filter, "triangle");
  EXPECT_EQ(back.max_depth, 7);
}

template <class Kind>
Kind light_back(const Kind& light) {
  SceneDescription scene = room();
  scene.images = {{"a/sky.hdr", Encoding::Linear, Wrap::Repeat, {}},
                  {"face.jpg", Encoding::LabGamma, Wrap::Clamp, {}}};
  test::add_light(scene, light);
  const RoundTrip trip = test::round_trip(scene);
  if (trip.scene.lights.size() == 1 && std::holds_alternative<Kind>(trip.scene.lights[0].kind))
    return std::get<Kind>(trip.scene.lights[0].kind);
  ADD_FAILURE() << trip.written.text;
  return {};
}

TEST(Unit_WriteLights, PointsSpotsAndSuns) {
  const PointLight point = light_back(PointLight{{0.1, 2, -3}, {1, 20, 1.0 / 3}});
  EXPECT_EQ(point.position, Vec3d(0.1, 2, -3));
  EXPECT_EQ(point.intensity, Vec3d(1, 20, 1.0 / 3));
  const SpotLight spot =
      light_back(SpotLight{{1, 2, 3}, normalize(Vec3d(1, -2, 0.5)), Vec3d(3), 0.2, 0.6});
  EXPECT_EQ(spot.position, Vec3d(1, 2, 3));
  expect_near(spot.axis, normalize(Vec3d(1, -2, 0.5)));
  EXPECT_NEAR(spot.inner_angle_radians, 0.2, rounding);
  EXPECT_NEAR(spot.outer_angle_radians, 0.6, rounding);
  const Vec3d up = normalize(Vec3d(0.3, 1, 0.2));
  const DirectionalLight sun = light_back(DirectionalLight{up, Vec3d(4, 3, 2)});
  expect_near(sun.to_light, up);
  EXPECT_EQ(sun.irradiance, Vec3d(4, 3, 2));
}

TEST(Unit_WriteLights, LightsThatAnImageShapes) {
  const double s = std::sqrt(0.5);
  const Mat3d turned(s, 0, -s, 0, 1, 0, s, 0, s);
  const auto expect_light = [&](const auto& back) {
    EXPECT_EQ(back.position, Vec3d(1, 2, 3));
    EXPECT_EQ(back.image.index, 0u);
    EXPECT_EQ(back.power, 7.5);
    for (int c = 0; c < 3; ++c) expect_near(back.world_from_map[c], turned[c]);
  };
  const GoniometricLight round =
      light_back(GoniometricLight{{1, 2, 3}, odd, ImageHandle(0), turned, 7.5});
  expect_light(round);
  EXPECT_EQ(round.intensity, odd);
  const ProjectionLight square =
      light_back(ProjectionLight{{1, 2, 3}, Vec3d(2.5), ImageHandle(0), turned, 40, 7.5});
  expect_light(square);
  EXPECT_EQ(square.intensity, Vec3d(2.5));
  EXPECT_EQ(square.angle_degrees, 40);
}

TEST(Unit_WriteLights, SkiesOfAllKinds) {
  const ConstantEnvironment constant = light_back(ConstantEnvironment{Vec3d(0.1, 0.2, 0.3), false});
  EXPECT_EQ(constant.radiance, Vec3d(0.1, 0.2, 0.3));
  EXPECT_FALSE(constant.is_seen_by_camera);
  const double s = std::sqrt(0.5);
  const Mat3d turned(s, 0, -s, 0, 1, 0, s, 0, s);
  const auto expect_map = [&](const auto& back) {
    EXPECT_EQ(back.image.index, 0u);
    expect_near(back.scale, Vec3d(1, 2, 3));
    EXPECT_FALSE(back.is_seen_by_camera);
    for (int c = 0; c < 3; ++c) expect_near(back.world_from_map[c], turned[c]);
  };
  expect_map(light_back(LatLongEnvironment{ImageHandle(0), {1, 2, 3}, turned, false}));
  expect_map(light_back(EqualAreaEnvironment{ImageHandle(0), {1, 2, 3}, turned, false}));
  CubeEnvironment cube;
  cube.faces.fill(ImageHandle(1));
  EXPECT_EQ(light_back(cube).faces,
            (std::array<ImageHandle, 6>{ImageHandle(0), ImageHandle(0), ImageHandle(0),
                                        ImageHandle(0), ImageHandle(0), ImageHandle(0)}));
}

// Several are several directives, each with the image that pbrt needs of it.
TEST(Unit_WriteLights, SkiesOneByOne) {
  SceneDescription scene = room();
  scene.images = {{"a/one.exr", Encoding::Linear, Wrap::Repeat, {}},
                  {"a/two.exr", Encoding::Linear, Wrap::Clamp, {}}};
  scene.lights.clear();
  test::add_light(scene, LatLongEnvironment{ImageHandle(0), {1, 2, 3}, Mat3d(1.0), true});
  test::add_light(scene, ConstantEnvironment{odd, true});
  test::add_light(scene, EqualAreaEnvironment{ImageHandle(1), {1, 1, 1}, Mat3d(1.0), true});
  test::add_light(scene, LatLongEnvironment{ImageHandle(1), {1, 1, 1}, Mat3d(1.0), true});
  const RoundTrip trip = test::round_trip(scene);
  ASSERT_EQ(trip.scene.lights.size(), 4u);
  EXPECT_TRUE(std::holds_alternative<LatLongEnvironment>(trip.scene.lights[0].kind));
  EXPECT_EQ(std::get<ConstantEnvironment>(trip.scene.lights[1].kind).radiance, odd);
  EXPECT_TRUE(std::holds_alternative<EqualAreaEnvironment>(trip.scene.lights[2].kind));
  EXPECT_TRUE(std::holds_alternative<LatLongEnvironment>(trip.scene.lights[3].kind));
  ASSERT_EQ(trip.written.skies.size(), 2u);
  EXPECT_EQ(trip.written.skies[0].light, 0u);
  EXPECT_EQ(trip.written.skies[1].light, 3u);
  EXPECT_NE(trip.written.skies[0].name, trip.written.skies[1].name);
}

TEST(Unit_WriteLights, CubesKeepTheirEncodingAndAreAskedForAsEqualAreas) {
  SceneDescription scene = room();
  scene.images = {{"face.jpg", Encoding::LabGamma, Wrap::Clamp, {}}};
  CubeEnvironment cube;
  cube.faces.fill(ImageHandle(0));
  test::add_light(scene, cube);
  const RoundTrip trip = test::round_trip(scene, {100, 100, 3, -1, false});
  ASSERT_EQ(trip.scene.images.size(), 1u);
  EXPECT_EQ(trip.scene.images[0].encoding, Encoding::LabGamma);
  ASSERT_EQ(trip.written.skies.size(), 1u);
  EXPECT_EQ(trip.written.skies[0].side, 246);  // 245 squared are the texels of six faces
  ASSERT_EQ(trip.written.images.size(), 1u);
  EXPECT_FALSE(trip.written.images[0].is_copied);
  EXPECT_TRUE(trip.written.images[0].name.ends_with("face.png"));
}

// Shining triangles of no mesh are surfaces for pbrt. Those that share corners are one lamp, last
// as when the scene itself is compiled.
TEST(Unit_WriteLights, TrianglesShineOnTheirOwn) {
  SceneDescription scene = room();
  const std::size_t instances = scene.instances.size();
  const TriangleLight light{{Vec3d(0, 1, 0), Vec3d(1, 1, 0), Vec3d(0, 1, 1)}, Vec3d(5), true};
  const TriangleLight other_half{{Vec3d(1, 1, 0), Vec3d(1, 1, 1), Vec3d(0, 1, 1)}, Vec3d(5), true};
  test::add_light(scene, light);
  test::add_light(scene, other_half);
  const SceneDescription back = test::round_trip(scene).scene;
  ASSERT_EQ(back.instances.size(), instances + 1);
  const Mesh& mesh = back.meshes[back.instances.back().mesh.index];
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.positions[1], Vec3d(1, 1, 0));
  EXPECT_EQ(mesh.positions[4], Vec3d(1, 1, 1));
  const Material& material = back.materials[mesh.materials[0].index];
  EXPECT_EQ(material.emission, Vec3d(5));
  EXPECT_TRUE(material.emits_both_sides);
  EXPECT_EQ(std::get<DiffuseMaterial>(material.model).reflectance.factor, Vec3d(0));
}

}  // namespace
}  // namespace candela::pbrt
