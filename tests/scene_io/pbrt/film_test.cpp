// Cameras and films of pbrt scenes as candela describes them.
#include <gtest/gtest.h>

#include "renderer/math/constants.h"
#include "tests/scene_io/pbrt/pbrt_text.h"

namespace candela {
namespace {

using namespace description;
using test::expect_near;
using test::pbrt_error;
using test::pbrt_scene;
using test::pbrt_warning;
using test::pbrt_world;
using test::pbrt_world_error;

Camera camera_of(const std::string& text) {
  const auto scene = pbrt_scene(text + "\nWorldBegin");
  EXPECT_EQ(scene.cameras.size(), 1u);
  return scene.cameras.empty() ? Camera{} : scene.cameras[0];
}

TEST(Unit_PbrtCamera, LooksAlongZAndIsLeftHanded) {
  const Camera plain = camera_of("");
  expect_near(plain.target - plain.eye, {0, 0, 1});
  expect_near(plain.up, {0, 1, 0});
  EXPECT_TRUE(plain.is_mirrored);  // x is right, where a right-handed camera has -x
  EXPECT_FALSE(camera_of("Scale -1 1 1\nCamera \"perspective\"").is_mirrored);
  const Camera looking = camera_of("LookAt 3 4 5  3 4 0  0 1 0\nCamera \"perspective\"");
  expect_near(looking.eye, {3, 4, 5});
  expect_near(normalize(looking.target - looking.eye), {0, 0, -1});
  expect_near(looking.up, {0, 1, 0});
  EXPECT_TRUE(looking.is_mirrored);
}

TEST(Unit_PbrtCamera, LensesAndWindowsAreInTheCamerasUnit) {
  const Camera camera = camera_of(
      "Scale .5 .5 .5\nCamera \"perspective\" \"float fov\" 40 \"float lensradius\" 3 \"float "
      "focaldistance\" 7 \"float screenwindow\" [ -1 2 -3 4 ]");
  EXPECT_EQ(camera.fovy_degrees, 40);
  EXPECT_TRUE(camera.fov_is_of_shorter_side);
  EXPECT_NEAR(camera.lens_radius, 6, 1e-9);
  EXPECT_NEAR(camera.focus_distance, 14, 1e-9);
  ASSERT_TRUE(camera.screen_window);
  EXPECT_EQ(camera.screen_window->top, 4);
  const Camera flat = camera_of(
      "Scale .5 .5 .5\nCamera \"orthographic\"\nFilm \"rgb\" \"integer xresolution\" 200 \"integer "
      "yresolution\" 100");
  EXPECT_EQ(flat.kind, CameraKind::Orthographic);
  EXPECT_NEAR(flat.screen_window->right, 4, 1e-9);
  EXPECT_NEAR(flat.screen_window->top, 2, 1e-9);
}

// The picture's aspect may be another than the file's.
TEST(Unit_PbrtCamera, OrthographicOnesFollowThePicture) {
  const std::string film = "Film \"rgb\" \"integer xresolution\" 200 \"integer yresolution\" 100";
  const auto camera = [&](const std::string& parameters) {
    return camera_of("LookAt 1 2 3  0 0 0  0 1 0 Camera \"orthographic\" " + parameters + film);
  };
  EXPECT_FALSE(camera("").screen_window);
  EXPECT_TRUE(camera("").fov_is_of_shorter_side);
  EXPECT_NEAR(camera("\"float frameaspectratio\" 3 ").screen_window->right, 3, 1e-9);
  EXPECT_NEAR(camera("\"float screenwindow\" [ -1 2 -3 4 ] ").screen_window->top, 4, 1e-9);
}

// pbrt reads a lens and has none.
TEST(Unit_PbrtCamera, SphericalOnesHaveNoLens) {
  const auto scene = test::parse_pbrt_text(
      "Camera \"spherical\" \"float lensradius\" .1 \"float focaldistance\" 2\nWorldBegin");
  ASSERT_TRUE(scene);
  EXPECT_TRUE(scene.diagnostics.list().empty());
  EXPECT_EQ(scene->cameras.at(0).lens_radius, 0);
}

TEST(Unit_PbrtFilm, DefaultsArePbrts) {
  const RenderDefaults defaults = pbrt_world("").defaults;
  EXPECT_EQ(defaults.width, 1280);
  EXPECT_EQ(defaults.height, 720);
  EXPECT_EQ(defaults.samples_per_pixel, 16);
  EXPECT_EQ(defaults.max_depth, 5);
  EXPECT_EQ(defaults.filter, "gaussian");
  EXPECT_EQ(defaults.filter_radius, 1.5);
  EXPECT_EQ(
      pbrt_scene("Integrator \"volpath\" \"integer maxdepth\" 0\nWorldBegin").defaults.max_depth,
      0);
  const RenderDefaults stratified =
      pbrt_scene(
          "Sampler \"stratified\" \"integer xsamples\" 3\nPixelFilter \"triangle\"\nWorldBegin")
          .defaults;
  EXPECT_EQ(stratified.samples_per_pixel, 12);
  const auto samples = [](const std::string& sampler) {
    return pbrt_scene("Sampler " + sampler + "\nWorldBegin").defaults.samples_per_pixel;
  };
  EXPECT_EQ(samples("\"independent\""), 4);
  EXPECT_EQ(samples("\"random\""), 4);
  EXPECT_EQ(samples("\"halton\""), 16);
  EXPECT_EQ(samples("\"independent\" \"integer pixelsamples\" 7"), 7);
  EXPECT_EQ(stratified.filter_radius, 2);
}

TEST(Unit_PbrtFilm, FiltersWithNegativeParts) {
  const RenderDefaults defaults = pbrt_scene("PixelFilter \"mitchell\"\nWorldBegin").defaults;
  EXPECT_EQ(defaults.filter, "mitchell");
  EXPECT_EQ(defaults.filter_radius, 2);
  EXPECT_EQ(
      pbrt_scene("PixelFilter \"sinc\" \"float xradius\" 3\nWorldBegin").defaults.filter_radius, 3);
}

TEST(Unit_PbrtFilm, CropWindowsAndPixelBounds) {
  const std::string film = "Film \"rgb\" \"integer xresolution\" 200 \"integer yresolution\" 100 ";
  const auto expect_crop = [&](const std::string& parameter, double left, double right, double top,
                               double bottom) {
    const auto crop = pbrt_scene(film + parameter + "\nWorldBegin").defaults.crop;
    ASSERT_TRUE(crop) << parameter;
    EXPECT_EQ(crop->left, left);
    EXPECT_EQ(crop->right, right);
    EXPECT_EQ(crop->top, top);
    EXPECT_EQ(crop->bottom, bottom);
  };
  expect_crop("\"float cropwindow\" [ .25 .5 .125 2 ]", 0.25, 0.5, 0.125, 1);
  expect_crop("\"float cropwindow\" [ .5 .25 1 .125 ]", 0.25, 0.5, 0.125, 1);
  expect_crop("\"integer pixelbounds\" [ 50 100 10 20 ]", 0.25, 0.5, 0.1, 0.2);
  expect_crop("\"integer pixelbounds\" [ 100 50 20 10 ]", 0.25, 0.5, 0.1, 0.2);
  expect_crop("\"integer pixelbounds\" [ 0 1 0 1 ] \"float cropwindow\" [ .25 .5 .125 2 ]", 0.25,
              0.5, 0.125, 1);
  EXPECT_FALSE(pbrt_scene(film + "\nWorldBegin").defaults.crop);
}

TEST(Unit_PbrtFilm, TheImagingRatioIsInTheLight) {
  const auto scene = pbrt_scene(R"(Camera "perspective" "float shutterclose" .25
    Film "rgb" "float iso" 200
    WorldBegin
    LightSource "point" "rgb I" [ 1 2 3 ]
    LightSource "distant" "rgb L" [ 1 1 1 ]
    LightSource "infinite" "rgb L" [ 4 4 4 ]
    AreaLightSource "diffuse" "rgb L" [ 2 2 2 ]
    Shape "disk")");
  expect_near(std::get<PointLight>(scene.lights.at(0).kind).intensity, Vec3d(1, 2, 3) * 0.5);
  expect_near(std::get<DirectionalLight>(scene.lights.at(1).kind).irradiance, Vec3d(0.5));
  expect_near(std::get<ConstantEnvironment>(scene.lights.at(2).kind).radiance, Vec3d(2.0));
  expect_near(scene.materials.at(0).emission, Vec3d(1.0));
}

TEST(Unit_PbrtFilm, IsBalancedAsItSays) {
  const auto balance = [](const std::string& parameters) {
    return pbrt_scene("Film \"rgb\" " + parameters + "\nWorldBegin").defaults.white_balance_kelvins;
  };
  EXPECT_EQ(balance("\"float whitebalance\" 5000"), 5000.0);
  EXPECT_FALSE(balance(""));
  EXPECT_FALSE(balance("\"float whitebalance\" 0"));
  EXPECT_FALSE(balance("\"string sensor\" \"cie1931\""));
  // pbrt's default for real sensors.
  EXPECT_EQ(balance("\"string sensor\" \"canon_eos_5d\""), 6500.0);
  EXPECT_EQ(balance("\"string sensor\" \"canon_eos_5d\" \"float whitebalance\" 3000"), 3000.0);
  EXPECT_EQ(pbrt_warning("Film \"rgb\" \"string sensor\" \"canon_eos_5d\"\nWorldBegin"),
            "1:12: 'sensor' is not supported: the film is that of the CIE 1931 observer");
  EXPECT_EQ(pbrt_error("Film \"rgb\" \"float whitebalance\" -5\nWorldBegin"),
            "1:12: 'whitebalance' is -5, expected kelvins, or 0 for no balance");
}

TEST(Errors_PbrtFilm, WhatCannotBeHonouredIsNamed) {
  EXPECT_EQ(pbrt_warning("Integrator \"bdpt\" \"bool visualizestrategies\" true\nWorldBegin"),
            "1:12: the integrator 'bdpt' is rendered by 'path'");
  EXPECT_EQ(pbrt_warning("Camera \"realistic\" \"string lensfile\" \"x\"\nWorldBegin"),
            "1:8: cameras of type 'realistic' are not supported: 'perspective' is used");
  EXPECT_EQ(
      pbrt_error("Film \"rgb\" \"float cropwindow\" [ .5 .5 0 1 ]\nWorldBegin"),
      "1:12: 'cropwindow' is [0.5, 0.5, 0, 1], which holds no pixel: expected x0 < x1 and y0 < y1");
  EXPECT_EQ(pbrt_error("Film \"rgb\" \"integer pixelbounds\" [ 0 10 ]\nWorldBegin"),
            "1:12: 'pixelbounds' has 2 values, expected 4");
  EXPECT_EQ(pbrt_warning("PixelFilter \"mitchell\" \"float B\" 0 \"float C\" .3333\nWorldBegin"),
            "1:13: the mitchell filter's B is 0.333 here");
  EXPECT_EQ(pbrt_error("Film \"rgb\" \"integer xresolution\" 0\nWorldBegin"),
            "1:12: 'xresolution' is 0, expected 1 to 65536");
  EXPECT_EQ(pbrt_error("Camera \"perspective\" \"float screenwindow\" [ 1 -1 -1 1 ]\nWorldBegin"),
            "1:22: 'screenwindow' is [1, -1, -1, 1], expected left < right and bottom < top");
  EXPECT_EQ(pbrt_error("Scale 1 1 0\nCamera \"perspective\"\nWorldBegin"),
            "2:8: the camera's transform is singular");
  EXPECT_EQ(pbrt_error("Film \"rgb\" \"float iso\" 1e300\nWorldBegin"),
            "1:6: the film multiplies light by 1e+298, expected above 0 and below 1e+30");
  EXPECT_EQ(pbrt_error("Camera \"perspective\" \"float shutteropen\" 1 \"float shutterclose\" 0\n"
                       "WorldBegin"),
            "1:8: the shutter closes at 0, expected after it opens at 1");
}

TEST(Unit_PbrtFilm, AnExposureTimeOfTheFilmAsksForNoShutter) {
  const auto scene = pbrt_scene(
      "Camera \"perspective\" \"float shutteropen\" 0 \"float shutterclose\" 0\n"
      "Film \"rgb\" \"float exposuretime\" .5\nWorldBegin LightSource \"point\" \"rgb I\" [ 2 2 2 "
      "]");
  EXPECT_EQ(std::get<PointLight>(scene.lights.at(0).kind).intensity, Vec3d(1.0));
}

TEST(Errors_PbrtFilm, NumbersOutOfTheirRange) {
  const auto warning = [](const std::string& text) { return pbrt_warning(text + "\nWorldBegin"); };
  EXPECT_EQ(warning("Camera \"perspective\" \"float frameaspectratio\" -1"),
            "1:22: 'frameaspectratio' is -1, expected above 0: it is ignored");
  EXPECT_EQ(warning("Camera \"perspective\" \"float lensradius\" -.3"),
            "1:22: 'lensradius' is -0.3, expected at least 0: 0 is used");
  EXPECT_EQ(warning("Camera \"perspective\" \"float focaldistance\" 0 \"float lensradius\" 1"),
            "1:22: 'focaldistance' is 0, expected above 0: it is ignored");
  EXPECT_EQ(warning("Camera \"perspective\" \"float focaldistance\" 0"), "0 of them: ");
  EXPECT_EQ(warning("Film \"rgb\" \"float whitebalance\" 10"),
            "1:12: 'whitebalance' is 10, expected 100 to 1000000000: 100 is used");
  EXPECT_EQ(warning("Film \"rgb\" \"integer xresolution\" 32 \"integer yresolution\" 32 "
                    "\"integer pixelbounds\" [ 0 40 0 40 ]"),
            "1:62: 'pixelbounds' reaches beyond the picture: what lies outside is cut");
}

// Only where their values would change the picture.
TEST(Errors_PbrtFilm, WhatIsIgnored) {
  const std::string begin = "\nWorldBegin";
  EXPECT_EQ(pbrt_warning("Film \"rgb\" \"float scale\" 2" + begin),
            "1:12: 'scale' is ignored: it is pbrt-v3's");
  EXPECT_EQ(pbrt_warning("Film \"rgb\" \"float maxsampleluminance\" 2" + begin),
            "1:12: 'maxsampleluminance' is ignored: radiance is not clamped");
  EXPECT_EQ(pbrt_warning("PixelFilter \"gaussian\" \"float alpha\" 3" + begin),
            "1:13: the gaussian filter's alpha is 2 here");
  EXPECT_EQ(pbrt_warning("Film \"rgb\" \"float scale\" 1 PixelFilter \"gaussian\" \"float alpha\" "
                         "2 " +
                         begin),
            "0 of them: ");
}

// A name and one value; the form with a type, which pbrt does not have, counts as well.
TEST(Unit_PbrtFilm, OptionsAreNamesWithAValue) {
  const auto seed = [](const std::string& text) {
    return pbrt_scene(text + "\nWorldBegin").defaults.seed;
  };
  EXPECT_EQ(seed("Option \"seed\" 5"), 5u);
  EXPECT_EQ(seed("Option \"Seed\" [ 6 ]"), 6u);
  EXPECT_EQ(seed("Option \"integer seed\" 7"), 7u);
  EXPECT_EQ(seed("Option \"seed\" 5 Sampler \"sobol\" \"integer seed\" 8"), 8u);
  EXPECT_EQ(pbrt_warning("Option \"disablepixeljitter\" true\nWorldBegin"),
            "1:8: the option 'disablepixeljitter' is ignored");
  EXPECT_EQ(pbrt_warning("Option \"render-coord-sys\" \"world\"\nWorldBegin"),
            "1:8: the option 'rendercoordsys' is ignored");
  EXPECT_EQ(pbrt_warning("Option \"sed\" 5\nWorldBegin"),
            "1:8: 'sed' is no option of pbrt and is ignored, did you mean 'seed'?");
  EXPECT_EQ(pbrt_error("Option \"seed\" -1\nWorldBegin"),
            "1:15: Option \"seed\": found '-1', expected an integer of at least 0");
  EXPECT_EQ(pbrt_error("Option \"seed\" [ 1 2 ]\nWorldBegin"),
            "1:19: Option: found '2', expected one value of 'seed'");
}

// What no version of pbrt has is no wish that cannot be honoured, but a mistake.
TEST(Errors_PbrtFilm, TypesThatDoNotExist) {
  EXPECT_EQ(pbrt_error("Integrator \"volpth\"\nWorldBegin"),
            "1:12: 'volpth' is no integrator, did you mean 'volpath'?");
  EXPECT_EQ(pbrt_error("Sampler \"zsobl\"\nWorldBegin"),
            "1:9: 'zsobl' is no sampler, did you mean 'zsobol'?");
  EXPECT_EQ(pbrt_error("ColorSpace \"rec202\"\nWorldBegin"),
            "1:1: 'rec202' is no colour space, did you mean 'rec2020'?");
  EXPECT_EQ(pbrt_warning("ColorSpace \"rec2020\"\nWorldBegin"),
            "1:1: the colour space 'rec2020' is not supported: colours count as srgb");
  EXPECT_EQ(pbrt_world_error("MakeNamedMedium \"m\" \"string type\" \"homogenous\" "
                             "MediumInterface \"m\" \"\" Shape \"sphere\""),
            "2:17: 'homogenous' is no type of media, did you mean 'homogeneous'?");
}

// The window that pbrt makes of it: unit along the shorter side.
TEST(Unit_PbrtCamera, FrameAspectRatio) {
  const auto window_of = [](const std::string& parameters) {
    return pbrt_scene("Camera \"perspective\" " + parameters + "\nWorldBegin")
        .cameras.at(0)
        .screen_window.value_or(description::ScreenWindow{0, 0, 0, 0});
  };
  const auto wide = window_of("\"float frameaspectratio\" 2");
  EXPECT_EQ(std::vector<double>({wide.left, wide.right, wide.bottom, wide.top}),
            std::vector<double>({-2, 2, -1, 1}));
  const auto tall = window_of("\"float frameaspectratio\" .25");
  EXPECT_EQ(std::vector<double>({tall.left, tall.right, tall.bottom, tall.top}),
            std::vector<double>({-1, 1, -4, 4}));
  EXPECT_EQ(window_of("\"float frameaspectratio\" 2 \"float screenwindow\" [ -3 3 -1 1 ]").right,
            3);
}

// pbrt's path integrator does not see them.
TEST(Errors_PbrtFilm, MediaUnderAnIntegratorWithoutAny) {
  const std::string media = "WorldBegin\nMakeNamedMedium \"m\" \"string type\" \"homogeneous\"";
  EXPECT_NE(pbrt_warning("Integrator \"path\"\n" + media).find("does not see media"),
            std::string::npos);
  EXPECT_EQ(pbrt_warning("Integrator \"volpath\"\n" + media), "0 of them: ");
  EXPECT_EQ(pbrt_warning("Integrator \"path\"\nWorldBegin"), "0 of them: ");
}

TEST(Unit_PbrtCamera, ThatOfPbrtV3sEnvironmentIsOfLatitudesAndLongitudes) {
  const auto kind_of = [](const std::string& words) {
    return pbrt_scene("Camera " + words + "\nWorldBegin").cameras.at(0).kind;
  };
  EXPECT_EQ(kind_of("\"environment\""), CameraKind::LatLong);
  EXPECT_EQ(kind_of("\"spherical\""), CameraKind::EqualArea);
}

TEST(Errors_PbrtTransforms, ThatStretchCamerasAndPicturesOfLights) {
  EXPECT_EQ(pbrt_warning("Scale 2 1 1 LookAt 0 0 5 0 0 0 0 1 0 Camera \"perspective\"\n"
                         "WorldBegin Shape \"disk\" LightSource \"infinite\""),
            "1:45: the camera's transform stretches or shears, which is left out");
  EXPECT_EQ(pbrt_warning("Scale 2 2 2 LookAt 0 0 5 0 0 0 0 1 0 Camera \"perspective\"\n"
                         "WorldBegin Shape \"disk\" LightSource \"infinite\""),
            "0 of them: ");
  EXPECT_EQ(test::pbrt_world_warning(
                "Scale .5 1 1 LightSource \"projection\" \"string filename\" \"picture.png\""),
            "2:26: the light's transform stretches its picture, which is left out");
  EXPECT_EQ(pbrt_warning("WorldBegin Scale .5 1 1 LightSource \"goniometric\""), "0 of them: ");
  EXPECT_EQ(pbrt_warning("WorldBegin Scale .5 1 1 LightSource \"spot\""),
            "1:37: the light's transform stretches its cone, which stays round");
  EXPECT_EQ(pbrt_warning("WorldBegin Scale 2 -2 2 LightSource \"spot\""), "0 of them: ");
}

}  // namespace
}  // namespace candela
