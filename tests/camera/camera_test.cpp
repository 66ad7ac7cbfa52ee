// Where the rays of every kind of camera go.
#include "renderer/camera/camera.h"

#include <gtest/gtest.h>

#include "renderer/description/validate.h"
#include "renderer/scene/compile_camera.h"
#include "tests/scenes/description.h"

namespace candela {
namespace {

using description::ScreenWindow;

// Looks along -z from (1, 2, 3), +x to its right, on a picture of 4 x 2.
description::Camera camera_of(CameraKind kind) {
  description::Camera camera;
  camera.kind = kind;
  camera.eye = {1, 2, 3};
  camera.target = {1, 2, -2};
  camera.fovy_degrees = 90;
  return camera;
}

Camera compiled(const description::Camera& camera, int width = 4, int height = 2) {
  return compile_camera(camera, {{0, 0, 0}, 0.5}, {.width = width, .height = height});
}

void expect_ray(const description::Camera& camera, Vec2f film, const Vec3d& origin,
                const Vec3d& through, int width = 4, int height = 2) {
  const Ray ray = compiled(camera, width, height).generate_ray(film, {0.5f, 0.5f});
  EXPECT_LT(length(Vec3d(ray.origin) - origin * 0.5), 1e-6) << film.x << ' ' << film.y;
  EXPECT_LT(length(Vec3d(ray.direction) - normalize(through)), 2e-7) << film.x << ' ' << film.y;
}

const Vec3d eye{1, 2, 3};

TEST(Unit_Camera, PerspectiveShowsItsAngleOfView) {
  const description::Camera camera = camera_of(CameraKind::Perspective);
  expect_ray(camera, {0.5f, 0.5f}, eye, {0, 0, -1});
  expect_ray(camera, {1, 0.5f}, eye, {2, 0, -1});
  expect_ray(camera, {0.5f, 0}, eye, {0, 1, -1});
}

// Whose squares are 0 or no number.
TEST(Unit_Camera, AnyLengthsGiveRays) {
  const auto ray_of = [](const description::Camera& camera, double scale, Vec2f lens) {
    return compile_camera(camera, {{0, 0, 0}, scale}, {.width = 4, .height = 2})
        .generate_ray({0.5f, 0.5f}, lens);
  };
  description::Camera tiny = camera_of(CameraKind::Perspective);
  tiny.eye *= 0x1p-700;
  tiny.target *= 0x1p-700;
  tiny.up *= 0x1p-700;
  const Ray ray = ray_of(tiny, 0x1p699, {0.5f, 0.5f});
  EXPECT_LT(length(ray.origin - Vec3f(0.5f, 1, 1.5f)), 1e-6f);
  EXPECT_LT(length(ray.direction - Vec3f(0, 0, -1)), 1e-6f);
  description::Camera focused = camera_of(CameraKind::Perspective);
  focused.lens_radius = 1;
  focused.focus_distance = 1e30;
  EXPECT_LT(length(ray_of(focused, 1, {0.9f, 0.5f}).direction - Vec3f(0, 0, -1)), 1e-6f);
}

TEST(Unit_Camera, MirroredExchangesLeftAndRight) {
  for (const CameraKind kind :
       {CameraKind::Perspective, CameraKind::Orthographic, CameraKind::LatLong}) {
    const description::Camera camera = camera_of(kind);
    description::Camera mirrored = camera;
    mirrored.is_mirrored = true;
    for (const float y : {0.1f, 0.5f, 0.8f})
      for (const float x : {0.0f, 0.25f, 0.4f}) {
        const Ray a = compiled(camera).generate_ray({x, y}, {});
        const Ray b = compiled(mirrored).generate_ray({1 - x, y}, {});
        EXPECT_LT(length(a.origin - b.origin), 1e-6f);
        EXPECT_LT(length(a.direction - b.direction), 1e-6f);
      }
    EXPECT_LT(compiled(mirrored).right.x, 0);
  }
}

TEST(Unit_Camera, AngleOfTheShorterSide) {
  description::Camera camera = camera_of(CameraKind::Perspective);
  camera.fov_is_of_shorter_side = true;
  expect_ray(camera, {1, 0}, eye, {1, 2, -1}, 2, 4);
  expect_ray(camera, {1, 0}, eye, {2, 1, -1}, 4, 2);
}

TEST(Unit_Camera, ScreenWindowIsWhatIsSeen) {
  description::Camera camera = camera_of(CameraKind::Perspective);
  camera.screen_window = ScreenWindow{0, 1, -0.5, 2};
  expect_ray(camera, {0, 1}, eye, {0, -0.5, -1});
  expect_ray(camera, {1, 0}, eye, {1, 2, -1});
  expect_ray(camera, {0.5f, 0.5f}, eye, {0.5, 0.75, -1});
}

TEST(Unit_Camera, OrthographicRaysAreParallel) {
  description::Camera camera = camera_of(CameraKind::Orthographic);
  expect_ray(camera, {1, 0}, eye + Vec3d(2, 1, 0), {0, 0, -1});
  camera.screen_window = ScreenWindow{-6, 0, 0, 3};
  expect_ray(camera, {0, 0}, eye + Vec3d(-6, 3, 0), {0, 0, -1});
  expect_ray(camera, {1, 1}, eye, {0, 0, -1});
  EXPECT_FLOAT_EQ(compiled(camera).distance_to(Vec3f(0, 0, -4)), 5.5f);
}

// Whatever point of the lens a ray starts at, it passes the point in focus of the ray through the
// lens' middle.
TEST(Unit_Camera, LensesFocusAtTheirDistance) {
  for (const CameraKind kind : {CameraKind::Perspective, CameraKind::Orthographic}) {
    description::Camera camera = camera_of(kind);
    const Ray middle = compiled(camera).generate_ray({0.8f, 0.3f}, {});
    camera.lens_radius = 0.5;
    camera.focus_distance = 4;
    const Vec3f focus = middle.origin + middle.direction * (2 / -middle.direction.z);
    const Camera with_lens = compiled(camera);
    for (const Vec2f lens : {Vec2f(0, 0), Vec2f(0.2f, 0.9f), Vec2f(1, 0.5f)}) {
      const Ray ray = with_lens.generate_ray({0.8f, 0.3f}, lens);
      EXPECT_GT(length(ray.origin - middle.origin), 0.1f);
      EXPECT_LT(length(cross(focus - ray.origin, ray.direction)), 1e-6f);
    }
  }
}

TEST(Unit_Camera, LatLongSeesAllAround) {
  const description::Camera camera = camera_of(CameraKind::LatLong);
  expect_ray(camera, {0.5f, 0.5f}, eye, {0, 0, -1});
  expect_ray(camera, {0.75f, 0.5f}, eye, {1, 0, 0});
  expect_ray(camera, {0.25f, 0.5f}, eye, {-1, 0, 0});
  expect_ray(camera, {0, 0.5f}, eye, {0, 0, 1});
  expect_ray(camera, {0.3f, 0}, eye, {0, 1, 0});
  expect_ray(camera, {0.5f, 0.75f}, eye, {0, -1, -1});
}

TEST(Unit_Camera, EqualAreaSeesAllAround) {
  const description::Camera camera = camera_of(CameraKind::EqualArea);
  expect_ray(camera, {0.5f, 0.5f}, eye, {0, 1, 0});
  expect_ray(camera, {1, 0.5f}, eye, {1, 0, 0});
  expect_ray(camera, {0.5f, 1}, eye, {0, 0, -1});
  expect_ray(camera, {0, 0}, eye, {0, -1, 0});
  // As filters reach out: folded back about the middle of the edge.
  expect_ray(camera, {1.25f, 0.5f}, eye, {std::sqrt(7.0), 3, 0});
  expect_ray(camera, {0.5f, -0.25f}, eye, {0, 3, std::sqrt(7.0)});
}

std::string error_of(const description::Camera& camera) {
  description::SceneDescription scene = test::small_room();
  scene.cameras[0] = camera;
  const Diagnostics found = description::validate(scene);
  return found.has_errors() ? found.list().front().message : "";
}

TEST(Errors_Camera, WindowsAndLenses) {
  description::Camera camera = camera_of(CameraKind::Perspective);
  camera.screen_window = ScreenWindow{1, 1, -1, 1};
  EXPECT_EQ(
      error_of(camera),
      "a camera's screen window is 1 to 1 by -1 to 1, expected left < right and bottom < top");
  camera = camera_of(CameraKind::LatLong);
  EXPECT_EQ(error_of(camera), "");
  camera.screen_window = ScreenWindow{};
  EXPECT_EQ(error_of(camera), "a camera that sees all around has no screen window");
  camera.screen_window.reset();
  camera.lens_radius = 1;
  EXPECT_EQ(error_of(camera), "a camera that sees all around has no lens");
}

}  // namespace
}  // namespace candela
