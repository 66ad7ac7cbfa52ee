// Tokens, parameters, blocks and files of pbrt scenes, and what is said about broken ones.
#include <gtest/gtest.h>

#include "renderer/base/thread_clock.h"
#include "scene_io/pbrt/token.h"
#include "tests/scene_io/pbrt/pbrt_text.h"

namespace candela {
namespace {

using test::parse_pbrt_text;
using test::pbrt_error;
using test::pbrt_scene;
using test::pbrt_warning;
using test::pbrt_world;
using test::pbrt_world_error;
using test::pbrt_world_warning;

std::vector<std::string> tokens_of(std::string_view text) {
  pbrt::Tokenizer tokens(text);
  std::vector<std::string> found;
  for (auto token = tokens.next(); token.kind != pbrt::TokenKind::End; token = tokens.next())
    found.push_back(std::to_string(static_cast<int>(token.kind)) + std::string(token.text));
  return found;
}

TEST(Unit_PbrtTokens, WordsStringsAndBracketsNeedNoBlanks) {
  EXPECT_EQ(tokens_of("Shape\"disk\"[1 2]# [ \"\n3"),
            (std::vector<std::string>{"1Shape", "2disk", "3[", "11", "12", "4]", "13"}));
  EXPECT_EQ(tokens_of("\"a \\\" b\" \"open\n2"),
            (std::vector<std::string>{"2a \\\" b", "5open", "12"}));
  EXPECT_EQ(tokens_of("1 # 2\r3\r\n4"), (std::vector<std::string>{"11", "13", "14"}));
  EXPECT_EQ(pbrt::unescaped("a\\n\\\\\\\"b\\"), "a\n\\\"b\\");
}

TEST(Unit_PbrtParse, TransformsMultiplyFromTheRight) {
  const auto scene = pbrt_world(R"(
    Translate 1 2 3
    AttributeBegin
      Scale 2 2 2  Rotate 90 0 0 1
      Shape "trianglemesh" "point3 P" [ 1 0 0  0 1 0  0 0 1 ]
    AttributeEnd
    ConcatTransform [ 1 0 0 0  0 1 0 0  0 0 1 0  10 0 0 1 ]
    Shape "trianglemesh" "point3 P" [ 1 0 0  0 1 0  0 0 1 ]
    Transform [ 1 0 0 0  0 1 0 0  0 0 1 0  0 5 0 1 ]
    Shape "trianglemesh" "point3 P" [ 1 0 0  0 1 0  0 0 1 ])");
  ASSERT_EQ(scene.instances.size(), 3u);
  const auto at = [&](std::size_t i) {
    return scene.instances[i].object_to_world.point({1, 0, 0});
  };
  EXPECT_LT(length(at(0) - Vec3d(1, 4, 3)), 1e-12);
  EXPECT_LT(length(at(1) - Vec3d(12, 2, 3)), 1e-12);
  EXPECT_LT(length(at(2) - Vec3d(1, 5, 0)), 1e-12);
}

TEST(Unit_PbrtParse, NamedCoordinateSystemsComeBack) {
  const auto scene = pbrt_scene(R"(
    LookAt 0 0 5  0 0 0  0 1 0
    Camera "perspective"
    WorldBegin
    Translate 7 0 0
    CoordinateSystem "here"
    Identity
    CoordSysTransform "here"
    Shape "disk"
    CoordSysTransform "camera"
    Shape "disk"
    CoordSysTransform "world"
    Shape "disk")");
  ASSERT_EQ(scene.instances.size(), 3u);
  const auto origin = [&](std::size_t i) { return scene.instances[i].object_to_world.translation; };
  EXPECT_EQ(origin(0), Vec3d(7, 0, 0));
  EXPECT_LT(length(origin(1) - Vec3d(0, 0, 5)), 1e-12);
  EXPECT_EQ(origin(2), Vec3d(0, 0, 0));
  EXPECT_EQ(pbrt_world_error("CoordSysTransform \"wurld\""),
            "2:1: there is no coordinate system 'wurld', did you mean 'world'?");
}

// Of the transforms of all times, whichever ActiveTransform names, as in pbrt.
TEST(Unit_PbrtParse, NamedCoordinateSystemsComeBackAtAllTimes) {
  const auto scene = pbrt_world(R"(CoordinateSystem "here"
    Translate 7 0 0
    ActiveTransform EndTime
    CoordSysTransform "here"
    Shape "disk")");
  EXPECT_EQ(scene.instances.at(0).object_to_world.translation, Vec3d(0.0));
}

TEST(Unit_PbrtParse, IncludedFilesMayHaveAByteOrderMark) {
  EXPECT_EQ(pbrt_world("Include \"marked.pbrt\"").instances.size(), 1u);
  EXPECT_NE(pbrt_world_error("Include \"wide.pbrt\"").find("is in UTF-16, expected UTF-8"),
            std::string::npos);
}

TEST(Errors_PbrtParse, TooFewNumbersAreToldAtTheirDirective) {
  EXPECT_EQ(pbrt_world_error("Translate 1 2\nMaterial \"diffuse\""),
            "2:1: Translate: found 'Material', expected a number");
}

TEST(Unit_PbrtParse, AttributesOfATargetAreDefaults) {
  const auto scene = pbrt_world(R"(
    AttributeBegin
      Attribute "shape" "float radius" 3 "float height" 1
      Attribute "shape" "float radius" 2
      Shape "disk"
      Shape "disk" "float radius" 5
    AttributeEnd
    Shape "disk")");
  ASSERT_EQ(scene.meshes.size(), 3u);
  const auto rim = [&](std::size_t i) { return length(scene.meshes[i].positions[0]); };
  EXPECT_NEAR(rim(0), std::sqrt(5.0), 1e-2);
  EXPECT_NEAR(rim(1), std::sqrt(26.0), 1e-2);
  EXPECT_NEAR(rim(2), 1, 1e-2);
}

// As in pbrt, whose lists are searched from their end.
TEST(Unit_PbrtParse, TheLastOfEqualParametersCounts) {
  const std::string twice = "\"rgb reflectance\" [ .1 .1 .1 ] \"rgb reflectance\" [ .7 .7 .7 ]";
  for (const std::string& text : {"Material \"diffuse\" " + twice,
                                  "Attribute \"material\" " + twice + " Material \"diffuse\""}) {
    const auto scene = pbrt_world(text + " Shape \"disk\"");
    const auto& material = std::get<description::DiffuseMaterial>(scene.materials.at(0).model);
    EXPECT_EQ(material.reflectance.factor, Vec3d(.7));
  }
}

TEST(Unit_PbrtParse, IncludedFilesChangeTheStateAndImportedOnesDoNot) {
  const auto included = pbrt_world("Include \"state.pbrt\"\nShape \"sphere\"");
  ASSERT_EQ(included.instances.size(), 2u);
  EXPECT_EQ(included.instances[1].object_to_world.translation, Vec3d(1, 0, 0));
  EXPECT_EQ(included.materials.size(), 1u);
  const auto imported = pbrt_world("Import \"state.pbrt\"\nShape \"sphere\"");
  ASSERT_EQ(imported.instances.size(), 2u);
  EXPECT_EQ(imported.instances[0].object_to_world.translation, Vec3d(1, 0, 0));
  EXPECT_EQ(imported.instances[1].object_to_world.translation, Vec3d(0, 0, 0));
  EXPECT_EQ(imported.materials.size(), 2u);
  ASSERT_EQ(imported.files.size(), 2u);
  EXPECT_EQ(imported.files[1], test::pbrt_folder() + "state.pbrt");
}

TEST(Unit_PbrtParse, ObjectsShareTheirMeshes) {
  const auto scene = pbrt_world(R"(
    ObjectBegin "pair"
      Shape "disk"
      Translate 0 0 1
      Shape "plymesh" "string filename" "triangle.ply"
    ObjectEnd
    ObjectInstance "pair"
    AttributeBegin
      Translate 5 0 0
      ObjectInstance "pair"
    AttributeEnd)");
  EXPECT_EQ(scene.meshes.size(), 2u);
  ASSERT_EQ(scene.instances.size(), 4u);
  EXPECT_EQ(scene.instances[3].mesh, scene.instances[1].mesh);
  EXPECT_EQ(scene.instances[3].object_to_world.translation, Vec3d(5, 0, 1));
}

TEST(Errors_PbrtParse, PlacesAndSuggestions) {
  EXPECT_EQ(pbrt_world_error("Shpae \"disk\""),
            "2:1: found 'Shpae', expected a directive, did you mean 'Shape'?");
  EXPECT_EQ(pbrt_world_error("Shape \"dsik\""), "2:7: 'dsik' is no shape, did you mean 'disk'?");
  EXPECT_EQ(pbrt_world_error("Shape \"disk\"\n  \"flaot radius\" 1"),
            "3:3: 'flaot' is not a type of parameters, did you mean 'float'?");
  EXPECT_EQ(pbrt_world_error("Shape \"disk\" \"float radius\" [ 1 2 ]"),
            "2:14: 'radius' has 2 values, expected 1");
  EXPECT_EQ(pbrt_world_error("Shape \"disk\" \"string radius\" \"1\""),
            "2:14: 'radius' is of type string, expected float");
  EXPECT_EQ(pbrt_world_error("Shape \"disk\" \"float radius\" 1x"),
            "2:29: \"float radius\": '1x' is not a number, expected a number");
  EXPECT_EQ(pbrt_world_error("Shape \"disk\" \"float radius\" true"),
            "2:29: \"float radius\": 'true' is not a number, expected a number");
  EXPECT_EQ(pbrt_world_error("Shape \"disk\" \"radius\" 1"),
            "2:14: found \"radius\", expected a type and a name, like \"float radius\"");
  EXPECT_EQ(pbrt_world_error("Shape \"disk\" 5"), "2:14: found '5', expected a directive");
  EXPECT_EQ(pbrt_world_error("Translate 1 2"),
            "2:14: Translate: found the end of the file, expected a number");
  EXPECT_EQ(pbrt_world_error("Scale 1 0 1\nShape \"disk\""),
            "3:7: the current transform is singular and flattens this shape");
  EXPECT_EQ(pbrt_world_error("NamedMaterial \"x\"\nShape \"disk\""),
            "2:15: there is no material 'x'");
  const std::string no_name = "a material without a name: expected one in the quotes";
  EXPECT_EQ(pbrt_world_error("NamedMaterial \"\"\nShape \"disk\""), "2:15: " + no_name);
  EXPECT_EQ(pbrt_world_error("MakeNamedMaterial \"\" \"string type\" \"diffuse\""),
            "2:19: " + no_name);
  EXPECT_EQ(pbrt_world_error("Include \"none.pbrt\"").substr(0, 7), "2:9: '/");
  EXPECT_EQ(pbrt_error("Film \"rgb\""), "1:1: there is no WorldBegin: expected a scene of pbrt-v4");
  EXPECT_EQ(pbrt_error("Shape \"disk\"\nWorldBegin"), "1:1: Shape before WorldBegin");
  EXPECT_EQ(pbrt_world_error("Camera \"perspective\""), "2:1: Camera after WorldBegin");
}

// What was told of one thing keeps nothing from being told of another with the same name.
TEST(Errors_PbrtParse, MessagesOfOneNameAreApart) {
  EXPECT_EQ(
      pbrt_world_error("Material \"hair\" Shape \"disk\"\nNamedMaterial \"hair\" Shape \"disk\""),
      "3:15: there is no material 'hair'");
  EXPECT_EQ(pbrt_world_error("Shape \"sphere\" \"float radius\" 1\n"
                             "Shape \"sphere\" \"bool radius\" true"),
            "3:16: 'radius' is of type bool, expected float");
}

TEST(Errors_PbrtParse, TheLineIsShownWithACaret) {
  const auto scene = parse_pbrt_text("WorldBegin\n  Shape \"dsik\"\n");
  ASSERT_EQ(scene.diagnostics.list().size(), 1u);
  EXPECT_EQ(scene.diagnostics.list()[0].excerpt, "  Shape \"dsik\"\n        ^");
}

// Lines of old Macs, which '\r' ends.
TEST(Errors_PbrtParse, CarriageReturnsEndLines) {
  EXPECT_EQ(pbrt_error("# a comment\rWorldBegin\r  Shape \"dsik\"\r"),
            "3:9: 'dsik' is no shape, did you mean 'disk'?");
  EXPECT_EQ(pbrt_scene("# a comment\rWorldBegin # another\rShape \"disk\"\r").meshes.size(), 1u);
}

TEST(Errors_PbrtParse, UnknownParametersAreWarnedOf) {
  EXPECT_EQ(pbrt_world_warning("Shape \"disk\" \"float raduis\" 1"),
            "2:14: 'raduis' is not a parameter of Shape \"disk\" and is ignored, did you mean "
            "'radius'?");
  EXPECT_EQ(pbrt_world_warning("Shape \"disk\" \"float radius\" 1 \"float radius\" 2"),
            "2:31: 'radius' is given twice; the last one counts");
}

TEST(Errors_PbrtParse, StatementsThatAnotherReplaces) {
  const std::vector<std::string> statements{"Camera \"perspective\"", "Sampler \"halton\"",
                                            "Integrator \"path\"", "Film \"rgb\"",
                                            "PixelFilter \"box\""};
  for (const std::string& statement : statements)
    EXPECT_EQ(pbrt_warning(statement + "\n" + statement + "\nWorldBegin"),
              "2:1: " + statement.substr(0, statement.find(' ')) +
                  " is given twice; the last one counts");
}

TEST(Errors_PbrtParse, ThoseThatAreNotToldAreCounted) {
  std::string errors, warnings;
  for (int i = 0; i < 50; ++i) {
    errors += "Foo\nIdentity\n";
    warnings += fmt::format("\"float p{}\" 1\n", i);
  }
  EXPECT_EQ(parse_pbrt_text("WorldBegin\n" + errors).diagnostics.error_count(), 50u);
  EXPECT_EQ(parse_pbrt_text("WorldBegin\nShape \"disk\"\n" + warnings).diagnostics.warning_count(),
            50u);
}

TEST(Errors_PbrtParse, AbsoluteNamesThatAnotherFileStandsFor) {
  EXPECT_EQ(pbrt_world_warning("Include \"/no/such/world.pbrt\""),
            fmt::format("2:9: file '{}world.pbrt' is taken for '/no/such/world.pbrt', which does "
                        "not exist",
                        test::pbrt_folder()));
}

TEST(Errors_PbrtParse, AllErrorsAtOnce) {
  const auto scene =
      parse_pbrt_text("WorldBegin\nShape 5\nTranslate a b c\nIdentity\nFoo\nShape \"disk\" 1");
  EXPECT_EQ(scene.diagnostics.error_count(), 4u);
}

TEST(Errors_PbrtParse, BlocksThatDoNotMatch) {
  EXPECT_EQ(pbrt_world_error("AttributeBegin\nAttributeBegin\nAttributeEnd"),
            "2:1: this AttributeBegin has no end");
  EXPECT_EQ(pbrt_world_error("TransformBegin"), "2:1: this TransformBegin has no end");
  EXPECT_EQ(pbrt_world_error("AttributeEnd"), "2:1: AttributeEnd without a begin");
  EXPECT_EQ(pbrt_world_error("ObjectBegin \"a\"\nObjectInstance \"a\"\nObjectEnd"),
            "3:1: an instance of 'a' within an ObjectBegin: objects cannot be made of instances");
  EXPECT_EQ(pbrt_world_error("ObjectInstance \"a\""), "2:1: there is no object 'a'");
  EXPECT_EQ(pbrt_world_error("Import \"unclosed.pbrt\""), "1:1: this block has no end in its file");
}

TEST(Errors_PbrtParse, FilesWithinThemselves) {
  EXPECT_NE(pbrt_world_error("Include \"self.pbrt\"").find("self.pbrt' includes itself"),
            std::string::npos);
  EXPECT_NE(pbrt_world_error("Include \"scene.pbrt\"").find("scene.pbrt' includes itself"),
            std::string::npos);
  EXPECT_EQ(pbrt_world_error("Include \"deep0.pbrt\""),
            "1:9: files include each other more than 64 deep");
}

// CPU time, however busy the machine is.
double seconds_of(const std::string& text) {
  const double begin = process_cpu_seconds();
  EXPECT_FALSE(parse_pbrt_text(text));
  return process_cpu_seconds() - begin;
}

// Each statement would hold them all.
TEST(Errors_PbrtParse, DefaultsOfManyNumbers) {
  std::string text = "Attribute \"shape\" \"float junk\" [";
  for (int i = 0; i < 100000; ++i) text += " 1";
  text += " ]\n";
  for (int i = 0; i < 4000; ++i) text += "Shape \"sphere\"\n";
  EXPECT_NE(pbrt_world_error(text).find(
                ":1: Attribute gives more than 268435456 bytes of parameters to what follows it"),
            std::string::npos);
}

TEST(Errors_PbrtParse, DefaultsOfManyNames) {
  std::string text;
  for (int i = 0; i <= 1000; ++i) text += fmt::format("Attribute \"shape\" \"float p{}\" 1\n", i);
  EXPECT_EQ(pbrt_world_error(text), "1002:11: Attribute: more than 1000 parameters of one target");
}

// Each ends in an error within some two seconds (ten where sanitizers look on), with little memory.
TEST(Errors_PbrtParse, WhatIsMadeToExhaustEndsSoon) {
  std::string blocks = "WorldBegin\n";
  for (int i = 0; i < 1000000; ++i) blocks += "AttributeBegin\n";
  EXPECT_LT(seconds_of(blocks), 10);
  EXPECT_LT(seconds_of("WorldBegin Shape \"disk\" \"float radius\" " + std::string(1000000, '9')),
            10);
  EXPECT_LT(seconds_of("WorldBegin Shape \"disk\" \"float radius\" [ " + std::string(1000000, '[')),
            10);
  EXPECT_LT(seconds_of("WorldBegin Shape \"plymesh\" \"string filename\" \"broken.ply\""), 10);
  EXPECT_LT(
      seconds_of("WorldBegin Shape \"loopsubdiv\" \"integer levels\" 19 \"point3 P\" [0 0 0 1 0 "
                 "0 0 1 0]"),
      10);
  std::string instances = "WorldBegin ObjectBegin \"o\"\n";
  for (int i = 0; i < 5000; ++i) instances += "Shape \"disk\"\n";
  instances += "ObjectEnd\n";
  for (int i = 0; i < 5000; ++i) instances += "ObjectInstance \"o\"\n";
  EXPECT_LT(seconds_of(instances), 10);
  std::string parameters;
  for (int i = 0; i < 200'000; ++i) parameters += "\"float p" + std::to_string(i) + "\" 1\n";
  EXPECT_LT(seconds_of("WorldBegin Shape \"disc\" " + parameters), 10);
  EXPECT_LT(seconds_of("WorldBegin Attribute \"shape\" " + parameters + "Attribute \"shape\" " +
                       parameters + "Shape \"disc\""),
            10);
  std::string texture = "WorldBegin\n";
  for (int i = 0; i < 2000; ++i)
    texture += "Texture \"t" + std::to_string(i) + "\" \"float\" \"scale\" \"texture tex\" \"t" +
               std::to_string(i + 1) + "\"\n";
  texture +=
      "Material \"diffuse\" \"texture reflectance\" \"t0\" \"texture displacement\" \"t0\"\n";
  EXPECT_LT(seconds_of(texture), 10);
}

// Exporters calculate in floats.
TEST(Unit_PbrtTransforms, RoundingOfTheLastRowIsNoPerspective) {
  const auto place_of = [](const std::string& last_column_end, const std::string& third) {
    return pbrt_world("Transform [ 2 0 0 " + third + "  0 2 0 0  0 0 2 0  4 0 0 " +
                      last_column_end + " ] Shape \"disk\"")
        .instances.at(0)
        .object_to_world.translation.x;
  };
  EXPECT_EQ(place_of("1", "0"), 4);
  EXPECT_NEAR(place_of(".9999999", "1e-12"), 4 / .9999999, 1e-12);
  for (const char* row :
       {"2 0 0 1e-7  0 2 0 0  0 0 2 0  0 0 0 1", "2 0 0 0  0 2 0 0  0 0 2 0  0 0 0 2"})
    EXPECT_NE(pbrt_world_error(std::string("Transform [ ") + row + " ]").find("is not affine"),
              std::string::npos)
        << row;
}

// Suggestions are made for what is told alone: 4000 of them took 12 seconds.
TEST(Unit_PbrtParse, ManyUnknownNamesEndSoon) {
  std::string text = "WorldBegin\n";
  for (int i = 0; i < 3000; ++i)
    text += fmt::format("MakeNamedMaterial \"material{}\" \"string type\" \"diffuse\"\n", i);
  for (int i = 0; i < 3000; ++i)
    text += fmt::format("NamedMaterial \"matter{}\" Shape \"disk\"\n", i);
  EXPECT_LT(seconds_of(text), 2);
}

}  // namespace
}  // namespace candela
