#include <gtest/gtest.h>

#include "tests/scene_io/lab3/lab3_text.h"

namespace candela {
namespace {

using test::error_in;
using test::said;
using test::scene_of;
using test::warning_in;

TEST(Unit_Lab3Cameras, EveryKey) {
  const auto scene = scene_of(
      "Cameras:\n"
      "  - Eye: [1, 2, 3]\n"
      "    Target: [4, 5, 6]\n"
      "    Up: [0, 0, 1]\n"
      "    Fovy: 39.3\n"
      "    ZNear: .1\n"
      "    ZFar: 200\n"
      "    LensRadius: .25\n"
      "    FocusDistance: 5\n"
      "  - Eye: [7, 8, 9]\n");
  ASSERT_EQ(scene.cameras.size(), 2u);
  const description::Camera& camera = scene.cameras[0];
  EXPECT_EQ(camera.eye, Vec3d(1, 2, 3));
  EXPECT_EQ(camera.target, Vec3d(4, 5, 6));
  EXPECT_EQ(camera.up, Vec3d(0, 0, 1));
  EXPECT_EQ(camera.fovy_degrees, 39.3);
  EXPECT_EQ(camera.lens_radius, 0.25);
  EXPECT_EQ(camera.focus_distance, 5);
  EXPECT_EQ(camera.span.line, 2u);
  EXPECT_EQ(scene.cameras[1].eye, Vec3d(7, 8, 9));
}

TEST(Unit_Lab3Cameras, Defaults) {
  const auto scene = scene_of("Cameras: [{}]\n");
  ASSERT_EQ(scene.cameras.size(), 1u);
  const description::Camera& camera = scene.cameras[0];
  EXPECT_EQ(camera.eye, Vec3d(0, 0, 1));
  EXPECT_EQ(camera.target, Vec3d(0, 0, 0));
  EXPECT_EQ(camera.up, Vec3d(0, 1, 0));
  EXPECT_EQ(camera.fovy_degrees, 60);
  EXPECT_EQ(camera.lens_radius, 0);
  EXPECT_EQ(camera.focus_distance, 0);
}

TEST(Unit_Lab3Cameras, WithoutCamerasOneFramesTheScene) {
  const std::string_view text =
      "AmbientIntensity: [0, 0, 0]\nModels: [{Mesh: triangle.obj, Material: a}]\n"
      "Materials: [{Name: a}]\n";
  const auto scene = scene_of(text);
  ASSERT_EQ(scene.cameras.size(), 1u);
  const description::Camera& camera = scene.cameras[0];
  EXPECT_EQ(camera.target, Vec3d(0.5, 0.5, 0));
  EXPECT_GT(camera.eye.z, 1);
  // The sphere about the bounds fits into the angle of view.
  const double sine = 0.5 * std::sqrt(2.0) / length(camera.eye - camera.target);
  EXPECT_NEAR(std::asin(sine), 0.5 * camera.fovy_degrees * 3.14159265358979 / 180, 1e-9);
  const auto notes = said(Severity::Note, text);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0],
            "no Cameras are given: one that sees all of the scene from the front is used");
  EXPECT_EQ(scene_of("Cameras: []\n").cameras.size(), 1u);
}

TEST(Errors_Lab3Cameras, CamerasThatSeeNothing) {
  EXPECT_EQ(error_in("Cameras:\n  - Eye: [1, 2, 3]\n    Target: [1, 2, 3]\n"),
            "2:10: Eye and Target are the same point: the camera looks nowhere");
  EXPECT_EQ(error_in("Cameras:\n  - Eye: [0, 0, 0]\n"),
            "2:10: Eye and Target are the same point: the camera looks nowhere");
  EXPECT_EQ(error_in("Cameras:\n  - Up: [0, 0, -3]\n"),
            "2:9: Up is parallel to the line of sight (Target - Eye): which way is up?");
  EXPECT_EQ(error_in("Cameras:\n  - Eye: [0, 5, 0]\n"),
            "2:5: Up is parallel to the line of sight (Target - Eye): which way is up?");
  EXPECT_EQ(error_in("Cameras:\n  - Up: [0, 0, 0]\n"),
            "2:9: Up: found [0, 0, 0], expected a direction");
}

TEST(Unit_Lab3Cameras, TinyAndHugeScenesHaveDirectionsToo) {
  for (const char* e : {"1e-200", "1e30"})
    EXPECT_TRUE(said(Severity::Error, fmt::format("Cameras: [{{Eye: [{}, 0, 0]}}]\n", e)).empty());
}

TEST(Errors_Lab3Cameras, NumbersOutOfRange) {
  for (const char* degrees : {"0", "180", "-20", "360"})
    EXPECT_EQ(error_in(fmt::format("Cameras:\n  - Fovy: {}\n", degrees)),
              fmt::format("2:11: Fovy: found '{}', expected an angle in degrees above 0 and below "
                          "180",
                          degrees));
  EXPECT_EQ(error_in("Cameras:\n  - LensRadius: -1\n"),
            "2:17: LensRadius: found '-1', expected a number of at least 0");
  EXPECT_EQ(error_in("Cameras:\n  - FocusDistance: 0\n"),
            "2:20: FocusDistance: found '0', expected a number above 0");
}

}  // namespace
}  // namespace candela
