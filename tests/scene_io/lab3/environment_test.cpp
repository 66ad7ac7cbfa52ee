// Skyboxes, Environment, AmbientIntensity and Render.
#include <gtest/gtest.h>

#include "tests/scene_io/lab3/lab3_text.h"

namespace candela {
namespace {

using namespace description;
using test::error_in;
using test::said;
using test::scene_of;
using test::warning_in;

constexpr std::string_view skybox =
    "Skyboxes:\n  - [rt.png, lt.png, up.png, dn.png, ft.png, bk.png]\n";

template <class Kind>
Kind only_light(const SceneDescription& scene) {
  if (scene.lights.size() != 1 || !std::holds_alternative<Kind>(scene.lights[0].kind)) {
    ADD_FAILURE() << scene.lights.size() << " lights, or another kind";
    return {};
  }
  return std::get<Kind>(scene.lights[0].kind);
}

TEST(Unit_Lab3Environment, AmbientIsAConstantThatTheCameraDoesNotSee) {
  const SceneDescription scene = scene_of("AmbientIntensity: [.1, .2, .3]\n");
  const auto ambient = only_light<ConstantEnvironment>(scene);
  EXPECT_EQ(ambient.radiance, Vec3d(0.1, 0.2, 0.3));
  EXPECT_FALSE(ambient.is_seen_by_camera);
  EXPECT_EQ(scene.lab_ambient, Vec3d(0.1, 0.2, 0.3));
}

TEST(Unit_Lab3Environment, AmbientDefaultsToTheLabs) {
  const SceneDescription scene = scene_of("Lights: []\n");
  EXPECT_EQ(only_light<ConstantEnvironment>(scene).radiance, Vec3d(0.1));
  EXPECT_EQ(scene.lab_ambient, Vec3d(0.1));
  const auto notes = said(Severity::Note, "Cameras: [{}]\n");
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0], "AmbientIntensity is not given: [0.1, 0.1, 0.1], as in lab3");
}

TEST(Unit_Lab3Environment, FilesOfTheExtensionHaveNoAmbientUnlessTheySaySo) {
  for (const char* text :
       {"Render: {Width: 5}\n", "Render: {}\n", "Render:\n",
        "Materials: [{Name: a, Type: diffuse}]\n", "Materials: [{Name: a, Emission: 0}]\n"}) {
    EXPECT_TRUE(scene_of(text).lights.empty()) << text;
    EXPECT_FALSE(scene_of(text).lab_ambient) << text;
  }
  const SceneDescription scene = scene_of("Render: {}\nAmbientIntensity: [1, 1, 1]\n");
  EXPECT_EQ(only_light<ConstantEnvironment>(scene).radiance, Vec3d(1.0));
}

TEST(Unit_Lab3Environment, TheOptionReplacesTheAmbient) {
  LoadOptions options;
  options.ambient = Vec3d(1, 2, 3);
  const SceneDescription scene = scene_of("AmbientIntensity: [.1, .2, .3]\n", options);
  EXPECT_EQ(only_light<ConstantEnvironment>(scene).radiance, Vec3d(1, 2, 3));
  EXPECT_EQ(scene.lab_ambient, Vec3d(1, 2, 3));
  options.ambient = Vec3d(0.0);
  const SceneDescription none = scene_of("AmbientIntensity: [.1, .2, .3]\n", options);
  EXPECT_TRUE(none.lights.empty());
  EXPECT_EQ(none.lab_ambient, Vec3d(0.0));  // given, in place of an environment's
  EXPECT_EQ(scene_of("Environment: {Radiance: .5}\nAmbientIntensity: [0, 0, 0]\n").lab_ambient,
            Vec3d(0.0));
}

TEST(Unit_Lab3Environment, SkyboxesTakeTheAmbientsPlace) {
  const SceneDescription scene = scene_of(fmt::format("{}AmbientIntensity: [1, 1, 1]\n", skybox));
  const auto cube = only_light<CubeEnvironment>(scene);
  const char* names[] = {"rt.png", "lt.png", "up.png", "dn.png", "ft.png", "bk.png"};
  for (std::size_t i = 0; i < 6; ++i) {
    const Image& image = scene.images.at(cube.faces[i].index);
    EXPECT_EQ(image.path, test::lab3_folder() + names[i]);
    EXPECT_EQ(image.encoding, Encoding::LabGamma);
    EXPECT_EQ(image.wrap, Wrap::Clamp);
  }
  EXPECT_EQ(scene.lab_ambient, Vec3d(1.0));  // whitted keeps it
}

TEST(Errors_Lab3Environment, Skyboxes) {
  EXPECT_EQ(error_in("Skyboxes: rt.png\n"),
            "1:11: Skyboxes: found 'rt.png', expected a list of lists of 6 image files (+X, -X, "
            "+Y, -Y, +Z, -Z)");
  EXPECT_EQ(error_in("Skyboxes: [rt.png, lt.png, up.png, dn.png, ft.png, bk.png]\n"),
            "1:11: Skyboxes: found a list of 6 values, expected a list of lists of 6 image files "
            "(+X, -X, +Y, -Y, +Z, -Z)");
  EXPECT_EQ(error_in("Skyboxes: [[rt.png, lt.png]]\n"),
            "1:12: a skybox: found a list of 2 values, expected 6 image files (+X, -X, +Y, -Y, +Z, "
            "-Z)");
  EXPECT_EQ(error_in("Skyboxes: [[rt.png, lt.png, upp.png, dn.png, ft.png, bk.png]]\n"),
            "1:29: 'upp.png': no such file for an image, did you mean 'up.png'?");
  EXPECT_EQ(warning_in(fmt::format("{}  - [a]\n", skybox)), "3:5: only the first skybox is used");
  EXPECT_TRUE(said(Severity::Error, "Skyboxes: []\n").empty());
}

TEST(Unit_Lab3Environment, Maps) {
  const SceneDescription scene = scene_of(
      "Environment: {Map: sky.hdr, Scale: [1, 2, 3], Rotation: 90, VisibleToCamera: false}\n");
  const auto map = only_light<LatLongEnvironment>(scene);
  EXPECT_EQ(scene.images.at(map.image.index).path, test::lab3_folder() + "sky.hdr");
  EXPECT_EQ(scene.images.at(map.image.index).encoding, Encoding::Linear);
  EXPECT_EQ(map.scale, Vec3d(1, 2, 3));
  EXPECT_FALSE(map.is_seen_by_camera);
  // A quarter turn about +y takes +z to +x.
  const Vec3d turned = map.world_from_map * Vec3d(0, 0, 1);
  EXPECT_NEAR(turned.x, 1, 1e-12);
  EXPECT_NEAR(turned.z, 0, 1e-12);
  const auto plain = scene_of("Environment: {Map: picture.png, Scale: 2}\n");
  EXPECT_EQ(plain.images.at(0).encoding, Encoding::Srgb);
  EXPECT_EQ(only_light<LatLongEnvironment>(plain).scale, Vec3d(2));
  EXPECT_TRUE(only_light<LatLongEnvironment>(plain).is_seen_by_camera);
  EXPECT_EQ(only_light<LatLongEnvironment>(plain).world_from_map, Mat3d(1.0));
}

TEST(Unit_Lab3Environment, Constants) {
  const auto grey = only_light<ConstantEnvironment>(scene_of("Environment: {Radiance: 2}\n"));
  EXPECT_EQ(grey.radiance, Vec3d(2));
  EXPECT_TRUE(grey.is_seen_by_camera);
  const auto scaled = only_light<ConstantEnvironment>(scene_of(
      "Environment: {Radiance: [1, 2, 3], Scale: .5, VisibleToCamera: no}\nAmbientIntensity: [9, "
      "9, 9]\n"));
  EXPECT_EQ(scaled.radiance, Vec3d(0.5, 1, 1.5));
  EXPECT_FALSE(scaled.is_seen_by_camera);
  EXPECT_EQ(warning_in("Environment: {Radiance: 1, Rotation: 5}\n"),
            "1:28: Rotation has no effect on a constant Radiance");
}

TEST(Errors_Lab3Environment, Environments) {
  EXPECT_EQ(error_in("Environment: {}\n"), "1:1: an Environment needs a Map or a Radiance");
  EXPECT_EQ(error_in("Environment:\n"), "1:1: found nothing, expected the keys of an Environment");
  EXPECT_EQ(error_in("Environment: {Scale: x, VisibleToCamera: 5}\n"),
            "3 of them: 1:22: Scale: found 'x', expected a number of at least 0 | 1:42: "
            "VisibleToCamera: found '5', expected true or false | 1:1: an Environment needs a Map "
            "or a Radiance");
  EXPECT_EQ(error_in("Environment: {Map: sky.hdr, Radiance: 1}\n"),
            "1:1: both Map and Radiance are given, expected one of them");
  EXPECT_EQ(error_in(fmt::format("{}Environment: {{Radiance: 1}}\n", skybox)),
            "3:1: both Skyboxes and Environment are given, expected one of them");
  EXPECT_EQ(error_in("Environment: {Map: skyy.hdr}\n"),
            "1:20: 'skyy.hdr': no such file for an image, did you mean 'sky.hdr'?");
  EXPECT_EQ(error_in("Environment: {Radiance: -1}\n"),
            "1:25: Radiance: found '-1', expected a number of at least 0");
  EXPECT_EQ(error_in("Environment: sky.hdr\n"),
            "1:14: found 'sky.hdr', expected the keys of an Environment");
  EXPECT_EQ(error_in("AmbientIntensity: [.1, -.1, .1]\n"),
            "1:24: AmbientIntensity: found '-.1', expected a number of at least 0");
}

TEST(Unit_Lab3Render, EveryKey) {
  const RenderDefaults defaults =
      scene_of(
          "Render: {Width: 640, Height: 480, SamplesPerPixel: 16, MaxDepth: 5, Integrator: Path, "
          "Filter: BlackmanHarris, Seed: 7, Exposure: -1.5, WhiteBalance: 4500}\n")
          .defaults;
  EXPECT_EQ(defaults.width, 640);
  EXPECT_EQ(defaults.height, 480);
  EXPECT_EQ(defaults.samples_per_pixel, 16);
  EXPECT_EQ(defaults.max_depth, 5);
  EXPECT_EQ(defaults.integrator, "path");
  EXPECT_EQ(defaults.filter, "blackman_harris");
  EXPECT_EQ(defaults.seed, 7u);
  EXPECT_EQ(defaults.exposure, -1.5);
  EXPECT_EQ(defaults.white_balance_kelvins, 4500.0);
  EXPECT_EQ(scene_of("Render: {spp: 8}\n").defaults.samples_per_pixel, 8);
}

TEST(Unit_Lab3Render, SaysNothingUnlessAsked) {
  const RenderDefaults defaults = scene_of("Render: {MaxDepth: none}\n").defaults;
  EXPECT_FALSE(defaults.width);
  EXPECT_FALSE(defaults.samples_per_pixel);
  EXPECT_FALSE(defaults.max_depth);
  EXPECT_FALSE(defaults.integrator);
  EXPECT_FALSE(defaults.seed);
}

TEST(Errors_Lab3Render, Values) {
  EXPECT_EQ(error_in("Render: {Width: 0}\n"),
            "1:17: Width: found '0', expected a whole number from 1 to 65536");
  EXPECT_EQ(error_in("Render: {Width: 5.5}\n"),
            "1:17: Width: found '5.5', expected a whole number from 1 to 65536");
  EXPECT_EQ(error_in("Render: {Seed: -1}\n"),
            "1:16: Seed: found '-1', expected a whole number from 0 to 9223372036854775807");
  EXPECT_EQ(error_in("Render: {Integrator: pth}\n"),
            "1:22: Integrator: found 'pth', expected path, report, whitted or raster, did you mean "
            "'path'?");
  EXPECT_EQ(error_in("Render: {Filter: tent}\n"),
            "1:18: Filter: found 'tent', expected box, gaussian, blackman_harris, triangle, "
            "mitchell or sinc");
  EXPECT_EQ(error_in("Render: {MaxDepth: -1}\n"),
            "1:20: MaxDepth: found '-1', expected a whole number from 0 to 1000000 or none");
  EXPECT_EQ(error_in("Render: 5\n"), "1:9: found '5', expected the keys of Render");
  EXPECT_EQ(warning_in("Render: {SamplesPerPixel: 4, spp: 8}\n"),
            "1:10: SamplesPerPixel is overridden by spp");
}

TEST(Unit_Lab3Render, WhatTheIntegratorMakesNothingOfIsWarnedOf) {
  EXPECT_EQ(warning_in("Render: {Integrator: raster, MaxDepth: 3}\n"),
            "1:30: MaxDepth has no effect: raster follows no ray beyond the first surface");
  EXPECT_EQ(warning_in("Render: {Integrator: whitted, MaxDepth: none}\n"),
            "1:31: MaxDepth has no effect: whitted needs a limit, which is 5 then");
  EXPECT_EQ(warning_in("Render: {Integrator: whitted, Filter: gaussian}\n"),
            "1:31: Filter has no effect: whitted averages its grid of samples, which is a box "
            "filter");
  for (const char* keys :
       {"Integrator: whitted, MaxDepth: 3, Filter: box", "Integrator: raster, SamplesPerPixel: 4",
        "MaxDepth: none, Filter: sinc"})
    EXPECT_TRUE(said(Severity::Warning, fmt::format("Render: {{{}}}\n", keys)).empty()) << keys;
}

TEST(Unit_Lab3Reflection, IsReadAndIgnored) {
  EXPECT_TRUE(said(Severity::Warning, "Reflection: Empirical\n").empty());
  EXPECT_EQ(warning_in("Reflection: PhysicalMetallic\n"),
            "1:13: Reflection: PhysicalMetallic is read by nothing in lab3: materials without a "
            "Type are Empirical (Blinn-Phong)");
  EXPECT_EQ(error_in("Reflection: Empiric\n"),
            "1:13: Reflection: found 'Empiric', expected Empirical, PhysicalMetallic or "
            "PhysicalSpecular, did you mean 'Empirical'?");
}

}  // namespace
}  // namespace candela
