// What holds for every key: numbers, lists, names, keys given twice, keys that do not exist.
#include "scene_io/lab3/fields.h"

#include <gtest/gtest.h>

#include "tests/scene_io/lab3/lab3_text.h"

namespace candela {
namespace {

using test::error_in;
using test::said;
using test::scene_of;
using test::warning_in;

std::string fovy(std::string_view value) {
  return fmt::format("Cameras: [{{Fovy: {}}}]\n", value);
}

std::string eye(std::string_view value) {
  return fmt::format("Cameras: [{{Eye: {}}}]\n", value);
}

TEST(Unit_Fields, NamesAreTheSameWhateverTheirCaseAndUnderscores) {
  EXPECT_TRUE(lab3::is_same_name("roughness_map", "RoughnessMap"));
  EXPECT_TRUE(lab3::is_same_name("kd", "KD"));
  EXPECT_FALSE(lab3::is_same_name("kd", "ks"));
  EXPECT_FALSE(lab3::is_same_name("kd", "kd2"));
  EXPECT_FALSE(lab3::is_same_name("_", "a"));
  EXPECT_TRUE(lab3::is_same_name("", "_"));
}

TEST(Unit_Fields, NumbersInEverySpellingOfTheLab) {
  for (const char* text : {"45", "45.", "+45", "4.5e1", "4.5E+1", "'45'", "\"45.0\""})
    EXPECT_EQ(scene_of(fovy(text)).cameras.at(0).fovy_degrees, 45) << text;
  EXPECT_EQ(scene_of(fovy(".5")).cameras.at(0).fovy_degrees, 0.5);
  EXPECT_EQ(scene_of(eye("[2e5, -.8, 1.]")).cameras.at(0).eye, Vec3d(2e5, -0.8, 1));
}

TEST(Errors_Fields, WhatIsNoNumber) {
  EXPECT_EQ(error_in(eye("[1, x, 3]")), "1:21: Eye: found 'x', expected a number");
  EXPECT_EQ(error_in(eye("[1, 2mm, 3]")), "1:21: Eye: found '2mm', expected a number");
  EXPECT_EQ(error_in(eye("[1, 0x10, 3]")), "1:21: Eye: found '0x10', expected a number");
  EXPECT_EQ(error_in(eye("[1, , 3]")), "1:21: Eye: found nothing, expected a number");
  EXPECT_EQ(error_in(eye("[1, [2], 3]")), "1:21: Eye: found a list of 1 value, expected a number");
  EXPECT_EQ(error_in(eye("[1, {a: 2}, 3]")), "1:21: Eye: found a map of keys, expected a number");
}

TEST(Errors_Fields, NumbersThatAreNotFiniteOrTooLarge) {
  for (const char* text : {".nan", ".inf", "-.inf", ".NaN", "nan", "inf", "-inf", "infinity"})
    EXPECT_EQ(error_in(eye(fmt::format("[1, {}, 3]", text))),
              fmt::format("1:21: Eye: found '{}', expected a finite number", text));
  for (const char* text : {"1e31", "-1e300", "1e999"})
    EXPECT_EQ(error_in(eye(fmt::format("[1, {}, 3]", text))),
              fmt::format("1:21: Eye: found '{}', expected a number of at most 1e30", text));
}

TEST(Errors_Fields, WhatIsNoVector) {
  EXPECT_EQ(error_in(eye("5")),
            "1:17: Eye: found '5', expected a list of 3 numbers, such as [5, 5, 5]");
  EXPECT_EQ(error_in(eye("up")), "1:17: Eye: found 'up', expected a list of 3 numbers");
  EXPECT_EQ(error_in(eye("")), "1:12: Eye: found nothing, expected a list of 3 numbers");
  EXPECT_EQ(error_in(eye("{x: 1}")),
            "1:17: Eye: found a map of keys, expected a list of 3 numbers");
  EXPECT_EQ(error_in(eye("[1, 2, 3, 4]")),
            "1:17: Eye: found a list of 4 values, expected at most 3 numbers");
}

// An example must be right itself.
TEST(Errors_Fields, NoExampleOutsideOfTheRange) {
  EXPECT_EQ(error_in("AmbientIntensity: -1\n"),
            "1:19: AmbientIntensity: found '-1', expected a list of 3 numbers");
  EXPECT_EQ(error_in(eye("0")), "1:17: Eye: found '0', expected a list of 3 numbers");
}

TEST(Errors_Fields, WhatLacksBlanksAndColons) {
  EXPECT_EQ(error_in("Cameras:\n  - Eye:[0, 1, 2]\n"),
            "2:5: found 'Eye:[0, 1, 2]', expected the keys of a camera; is a blank missing "
            "behind ':'?");
  EXPECT_EQ(warning_in("Cameras:\n  - Eye: [0, 1, 2]\n    target [0, 0, 0]:\n"),
            "3:5: unknown key 'target [0, 0, 0]' in a camera; is ':' missing behind 'target'?");
  EXPECT_EQ(warning_in("Cameras:\n  - Eye: [0, 1, 2]\n    target:[0, 0, 0]:\n"),
            "3:5: unknown key 'target:[0, 0, 0]' in a camera; is a blank missing behind "
            "'target:'?");
  EXPECT_EQ(warning_in("Cameras:\n  - Eye: [0, 1, 2]\n    <<: {}\n"),
            "3:5: merge keys (<<) are not read: write the keys out");
}

TEST(Unit_Fields, MissingEntriesOfVectorsAreOne) {
  EXPECT_EQ(scene_of(eye("[7, 8]")).cameras.at(0).eye, Vec3d(7, 8, 1));
  EXPECT_EQ(scene_of(eye("[7]")).cameras.at(0).eye, Vec3d(7, 1, 1));
  EXPECT_EQ(scene_of(eye("[]")).cameras.at(0).eye, Vec3d(1, 1, 1));
  EXPECT_EQ(warning_in(eye("[7, 8]")),
            "1:17: Eye: found a list of 2 values, expected 3 numbers; "
            "lab3 takes 1 for what is missing");
  EXPECT_EQ(warning_in(eye("[]")),
            "1:17: Eye: found an empty list, expected 3 numbers; lab3 takes "
            "1 for what is missing");
}

TEST(Errors_Fields, KeysGivenTwice) {
  EXPECT_EQ(error_in("Cameras:\n  - Fovy: 40\n    Eye: [0, 0, 1]\n    Fovy: 50\n"),
            "4:5: key 'Fovy' is given twice, first in line 2");
  EXPECT_EQ(error_in("Lights: []\nlights: []\n"),
            "2:1: key 'lights' is given twice, first in line 1");
}

TEST(Errors_Fields, UnknownKeysGivenTwice) {
  EXPECT_EQ(error_in("Zebra: 1\nLights: []\nze_bra: 2\n"),
            "3:1: key 'ze_bra' is given twice, first in line 1");
  EXPECT_EQ(said(Severity::Warning, "Zebra: 1\nZebra: 2\n").size(), 1u);
  EXPECT_TRUE(said(Severity::Error, "Zebra: 1\nCameras: [{Zebra: 2}]\n").empty());
}

TEST(Unit_Fields, UnknownKeysAreWarnedOf) {
  EXPECT_EQ(warning_in("Camera: []\n"),
            "1:1: unknown key 'Camera' in a scene, did you mean 'Cameras'?");
  EXPECT_EQ(warning_in("Zebra: []\n"), "1:1: unknown key 'Zebra' in a scene");
  EXPECT_EQ(warning_in("Cameras: [{FoV: 40}]\n"),
            "1:12: unknown key 'FoV' in a camera, did you mean 'Fovy'?");
  EXPECT_EQ(warning_in("Lights: [{Intensty: [1, 1, 1]}]\n"),
            "1:11: unknown key 'Intensty' in a light, did you mean 'Intensity'?");
}

TEST(Errors_Fields, Lists) {
  EXPECT_EQ(error_in("Lights: {Type: Point}\n"),
            "1:9: Lights: found a map of keys, expected a list");
  EXPECT_EQ(error_in("Lights: [5]\n"), "1:10: found '5', expected the keys of a light");
  EXPECT_TRUE(said(Severity::Error, "Lights:\nModels:\nMaterials: []\nCameras: ~\n").empty());
}

TEST(Errors_Fields, AllOfThemAtOnceButNotEndlessly) {
  std::string text = "Lights:\n";
  for (int i = 0; i < 100; ++i) text += "  - Intensity: [1, -1, x]\n";
  EXPECT_EQ(said(Severity::Error, text).size(), Diagnostics::limit);
  EXPECT_EQ(test::parse_lab3_text(text).diagnostics.error_count(), 100u);
  EXPECT_EQ(said(Severity::Error, "Lights: 5\nCameras: 5\nMaterials: 5\n").size(), 3u);
}

TEST(Errors_Fields, ThoseThatAreNotToldAreCounted) {
  const auto counted = [](int cameras) {
    std::string text = "Cameras:\n";
    for (int i = 0; i < cameras; ++i) text += "  - {Fovy: 300, foo: 1}\n";
    const Diagnostics diagnostics = test::parse_lab3_text(text).diagnostics;
    return std::pair(diagnostics.error_count(), diagnostics.warning_count());
  };
  EXPECT_EQ(counted(50), std::pair(std::size_t{50}, std::size_t{50}));
  EXPECT_EQ(counted(20000).first, Diagnostics::most_counted) << "reading stops";
}

TEST(Unit_Fields, ExcerptsShowTheLineWithACaret) {
  const auto result = test::parse_lab3_text("Lights:\n  - Type: Pont\n");
  ASSERT_EQ(result.diagnostics.error_count(), 1u);
  EXPECT_EQ(result.diagnostics.list()[0].excerpt, "  - Type: Pont\n          ^");
}

TEST(Unit_Fields, ManyUnknownKeysAreCountedNotKept) {
  std::string text;
  for (int i = 0; i < 20000; ++i) text += fmt::format("Cameraz{}: 1\n", i);
  const auto result = test::parse_lab3_text(text);
  EXPECT_EQ(result.diagnostics.warning_count(), 20000u);
  EXPECT_LE(result.diagnostics.list().size(), Diagnostics::limit + 3);
}

}  // namespace
}  // namespace candela
