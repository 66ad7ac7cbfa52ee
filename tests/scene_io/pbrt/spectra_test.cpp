#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/description/validate.h"
#include "renderer/math/cie.h"
#include "renderer/math/colour.h"
#include "renderer/math/reflectance.h"
#include "tests/scene_io/pbrt/pbrt_text.h"

namespace candela {
namespace {

using test::pbrt_world;
using test::pbrt_world_error;

Vec3d intensity_of(const std::string& parameter) {
  const auto scene = pbrt_world("LightSource \"point\" " + parameter);
  return std::get<description::PointLight>(scene.lights.at(0).kind).intensity;
}

Vec3d reflectance_of(const std::string& parameter) {
  const auto scene = pbrt_world("Material \"diffuse\" " + parameter + " Shape \"disk\"");
  return std::get<description::DiffuseMaterial>(scene.materials.at(0).model).reflectance.factor;
}

void expect_near(const Vec3d& colour, const Vec3d& expected, double tolerance) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(colour[c], expected[c], tolerance) << c;
}

// Published: the white points of D65 and A, and Planck's law at 6504 K [CIE15].
TEST(Unit_PbrtSpectra, WhitePoints) {
  expect_near(colour_of_chromaticity(0.31272, 0.32903), Vec3d(1.0), 2e-3);
  const Vec3d warm = colour_of_light([](double nm) { return black_body(nm, 2856); });
  expect_near(warm, colour_of_chromaticity(0.44758, 0.40745), 2e-3);
  for (const double kelvin : {200.0, 1000.0, 2856.0, 6500.0, 1e5, 1e8})
    EXPECT_NEAR(luminance(colour_of_light([&](double nm) { return black_body(nm, kelvin); })), 1,
                1e-12)
        << kelvin;
}

TEST(Unit_PbrtSpectra, PlancksLaw) {
  // Ratios by the law itself: x^-5 / (e^(c2 / x T) - 1).
  const auto law = [](double nm, double kelvin) {
    return std::pow(nm, -5) / std::expm1(1.438776877e7 / (nm * kelvin));
  };
  for (const double kelvin : {1000.0, 3000.0, 6500.0})
    EXPECT_NEAR(black_body(450, kelvin) / black_body(650, kelvin),
                law(450, kelvin) / law(650, kelvin), 1e-9);
  EXPECT_NEAR(black_body(450, 500) / black_body(650, 500), law(450, 500) / law(650, 500), 1e-9);
}

TEST(Unit_PbrtSpectra, LightsHaveLuminanceOneButForRgb) {
  expect_near(intensity_of("\"rgb I\" [ 1 2 3 ]"), {1, 2, 3}, 0);
  expect_near(intensity_of("\"rgb I\" [ 1 2 3 ] \"float scale\" 2"), {2, 4, 6}, 0);
  EXPECT_NEAR(luminance(intensity_of("\"blackbody I\" 3000")), 1, 1e-3);
  EXPECT_NEAR(luminance(intensity_of("\"spectrum I\" [ 300 7 900 7 ]")), 1, 1e-3);
  EXPECT_NEAR(luminance(intensity_of("\"spectrum I\" \"white.spd\"")), 1, 1e-3);
  EXPECT_NEAR(luminance(intensity_of("\"spectrum I\" \"stdillum-F11\"")), 1, 1e-3);
  EXPECT_NEAR(luminance(intensity_of("")), 1, 0);
}

TEST(Unit_PbrtSpectra, ReflectancesAreTheirColourInWhiteLight) {
  expect_near(reflectance_of("\"spectrum reflectance\" [ 300 .25 900 .25 ]"), Vec3d(0.25), 1e-12);
  expect_near(reflectance_of("\"spectrum reflectance\" \"white.spd\""), Vec3d(1.0), 1e-12);
  const Vec3d red = reflectance_of("\"spectrum reflectance\" [ 300 .1 600 .1 601 .7 900 .7 ]");
  EXPECT_GT(red.x, 0.5);
  EXPECT_LT(red.z, 0.15);
}

TEST(Unit_PbrtSpectra, MetalsByName) {
  const auto scene = pbrt_world(
      "Material \"conductor\" \"spectrum eta\" \"metal-Au-eta\" \"spectrum k\" \"metal-Au-k\" "
      "Shape "
      "\"disk\"");
  const auto& gold = std::get<description::ConductorMaterial>(scene.materials.at(0).model);
  // The colour of pbrt's tables' reflectance by wavelength, whose red of 1.022 no surface has.
  expect_near(normal_reflectance(gold.eta, gold.k), {largest_metal_reflectance, 0.7816, 0.3439},
              2e-4);
}

// White light has the colour after it that it has by the reflectance of each wavelength.
TEST(Unit_PbrtSpectra, MetalsBySamples) {
  const auto scene = pbrt_world(
      "Material \"conductor\" \"spectrum eta\" [ 360 1.6 480 1.2 560 .6 830 .9 ] "
      "\"spectrum k\" [ 360 1.9 480 1.8 600 2.9 830 5 ] Shape \"disk\"");
  const auto& metal = std::get<description::ConductorMaterial>(scene.materials.at(0).model);
  const SampledSpectrum eta{{360, 480, 560, 830}, {1.6, 1.2, 0.6, 0.9}};
  const SampledSpectrum k{{360, 480, 600, 830}, {1.9, 1.8, 2.9, 5}};
  const Vec3d colour = colour_of_factor(
      [&](double wavelength) { return normal_reflectance(eta(wavelength), k(wavelength)); });
  EXPECT_LT(max_component(colour), 1);
  expect_near(normal_reflectance(metal.eta, metal.k), colour, 1e-9);
  expect_near(metal.eta, colour_of_factor(eta), 1e-9);
}

TEST(Unit_PbrtSpectra, MetalsThatNoneIsAreMetals) {
  for (const char* eta : {"[ 400 -1 700 -1 ]", "[ 400 1e200 700 1e200 ]"}) {
    const auto scene = pbrt_world(
        fmt::format("Material \"conductor\" \"spectrum eta\" {} \"spectrum k\" [ 400 0 700 0 ] "
                    "Shape \"disk\"",
                    eta));
    EXPECT_FALSE(description::validate(scene).has_errors()) << eta;
    EXPECT_TRUE(std::holds_alternative<description::ConductorMaterial>(scene.materials.at(0).model))
        << eta;
  }
}

TEST(Errors_PbrtSpectra, MetalsAreToldOfOnce) {
  EXPECT_EQ(test::pbrt_world_message("Material \"conductor\" \"spectrum eta\" [ 400 1 300 1 ] "
                                     "\"spectrum k\" [ 400 1 700 1 ] Shape \"disk\""),
            "2:22: 'eta' has the wavelength 300 in place 2: expected rising ones");
}

// pbrt's BlackbodySpectrum is 1 at its largest, and only lights scale it further.
TEST(Unit_PbrtSpectra, BlackBodiesThatReflect) {
  expect_near(reflectance_of("\"blackbody reflectance\" 3000"), {0.630, 0.369, 0.132}, 2e-3);
  expect_near(reflectance_of("\"blackbody reflectance\" 6500"), {0.756, 0.919, 1.0}, 2e-3);
}

TEST(Unit_PbrtSpectra, LightThatNobodySeesIsBlack) {
  for (const char* spectrum : {"[ 400 0 700 0 ]", "[ 840 1 900 1 ]"}) {
    const std::string light = fmt::format("LightSource \"point\" \"spectrum I\" {}", spectrum);
    const auto scene = pbrt_world(light);
    EXPECT_EQ(std::get<description::PointLight>(scene.lights.at(0).kind).intensity, Vec3d(0.0));
    EXPECT_NE(test::pbrt_world_message(light).find("'I' has no light that is seen: it is black"),
              std::string::npos)
        << test::pbrt_world_message(light);
  }
}

TEST(Errors_PbrtSpectra, WhatIsNoSpectrum) {
  EXPECT_EQ(pbrt_world_error("LightSource \"point\" \"spectrum I\" [ 400 1 300 1 ]"),
            "2:21: 'I' has the wavelength 300 in place 2: expected rising ones");
  EXPECT_EQ(pbrt_world_error("LightSource \"point\" \"spectrum I\" [ 400 ]"),
            "2:21: 'I' has 1 numbers, expected pairs of a wavelength and a value");
  EXPECT_EQ(pbrt_world_error("LightSource \"point\" \"rgb I\" [ 1 1 ]"),
            "2:21: 'I' has 2 numbers, expected 3");
  EXPECT_EQ(pbrt_world_error("LightSource \"point\" \"rgb I\" [ 1 1 -1 ]"),
            "2:21: 'I' has -1, expected at least 0");
  EXPECT_EQ(pbrt_world_error("LightSource \"point\" \"blackbody I\" 0"),
            "2:21: 'I' is 0, expected a temperature in kelvins, above 0");
  EXPECT_EQ(pbrt_world_error("LightSource \"point\" \"blackbody I\" [ 5000 1 2 ]"),
            "2:21: 'I' has 3 numbers, expected a temperature in kelvins, above 0");
  EXPECT_EQ(pbrt_world_error("LightSource \"point\" \"spectrum I\" [ \"stdillum-A\" \"x\" ]"),
            "2:21: 'I' has several values, expected one name or a list of numbers");
  EXPECT_EQ(pbrt_world_error("LightSource \"point\" \"spectrum I\" \"metal-Au-eta\""),
            "2:21: 'I' is 'metal-Au-eta', which is a spectrum of another kind: illuminants are for "
            "lights, metals and glasses for what reflects");
  EXPECT_NE(pbrt_world_error("LightSource \"point\" \"spectrum I\" \"quoted.spd\"")
                .find("holds 'oops', expected pairs of numbers"),
            std::string::npos);
  EXPECT_NE(pbrt_world_error("Material \"conductor\" \"spectrum eta\" \"metal-Cu-etta\"")
                .find("did you mean 'metal-Cu-eta'?"),
            std::string::npos);
}

}  // namespace
}  // namespace candela
