// One mistake in a pbrt scene is told by one message, error or warning, at its place.
#include <gtest/gtest.h>

#include "tests/scene_io/pbrt/pbrt_text.h"

namespace candela {
namespace {

using test::pbrt_message;
using test::pbrt_world_message;

TEST(Errors_PbrtOneMessage, ListsEndAtADirective) {
  const std::string world = "\nWorldBegin\nMaterial \"diffuse\"\nShape \"disk\"";
  EXPECT_EQ(pbrt_message("Camera \"perspective\" \"float fov\" [ 40" + world),
            "1:34: \"float fov\": found 'WorldBegin', expected the ] of this list");
  EXPECT_EQ(pbrt_message("Camera \"realistic\" \"string lensfile\" [ \"a\"" + world),
            "1:38: \"string lensfile\": found 'WorldBegin', expected the ] of this list");
  EXPECT_EQ(
      pbrt_world_message("AttributeBegin\nShape \"sphere\" \"float radius\" [ 1\nAttributeEnd"),
      "3:31: \"float radius\": found 'AttributeEnd', expected the ] of this list");
  EXPECT_EQ(pbrt_world_message("ObjectBegin \"a\"\nShape \"sphere\" \"float radius\" [ 1\n"
                               "ObjectEnd\nObjectInstance \"a\"\nObjectBegin \"b\"\nObjectEnd"),
            "3:31: \"float radius\": found 'ObjectEnd', expected the ] of this list");
  EXPECT_EQ(pbrt_world_message("Shape \"sphere\" \"float radius\" [ 1"),
            "2:31: \"float radius\": found the end of the file, expected the ] of this list");
}

TEST(Errors_PbrtOneMessage, ObjectsWithinObjects) {
  EXPECT_EQ(pbrt_world_message("ObjectBegin \"a\"\nShape \"disk\"\nObjectBegin \"b\"\nObjectEnd\n"
                               "Shape \"disk\"\nObjectEnd\nObjectInstance \"a\""),
            "4:1: ObjectBegin within an ObjectBegin, expected ObjectEnd first");
}

TEST(Errors_PbrtOneMessage, ValuesThatAreMissing) {
  const std::string world = "\nWorldBegin\nMaterial \"diffuse\"\nShape \"disk\"";
  EXPECT_EQ(pbrt_message("Camera \"perspective\" \"string foo\"" + world),
            "1:22: \"string foo\": found 'WorldBegin', expected a string in quotes");
  EXPECT_EQ(pbrt_world_message("Shape \"sphere\" \"float radius\""),
            "2:16: \"float radius\": found the end of the file, expected a number");
  EXPECT_EQ(pbrt_message("Option \"bar\"" + world),
            "1:8: Option: found 'WorldBegin', expected one value of 'bar'");
  EXPECT_EQ(pbrt_message("Option \"seed\" [ 5" + world),
            "1:8: Option: found 'WorldBegin', expected one value of 'seed'");
  EXPECT_EQ(pbrt_world_message("Shape \"disk\nShape \"disk\""),
            "2:7: Shape: found a quote that is not closed on its line, expected a type in quotes");
  EXPECT_EQ(pbrt_message("Option \"bar\""),
            "1:8: Option: found the end of the file, expected one value of 'bar'");
}

TEST(Errors_PbrtOneMessage, WithoutWorldBegin) {
  const std::string world = "\nMaterial \"diffuse\"\nAttributeBegin\nShape \"disk\"\nAttributeEnd";
  EXPECT_EQ(pbrt_message("Camera \"perspective\"" + world), "2:1: Material before WorldBegin");
  EXPECT_EQ(pbrt_message("WorldBegn" + world),
            "1:1: found 'WorldBegn', expected a directive, did you mean 'WorldBegin'?");
}

TEST(Errors_PbrtOneMessage, MisspelledBlocks) {
  EXPECT_EQ(pbrt_world_message("ObjectBegn \"a\"\nShape \"disk\"\nObjectEnd\nObjectInstance \"a\""),
            "2:1: found 'ObjectBegn', expected a directive, did you mean 'ObjectBegin'?");
  EXPECT_EQ(pbrt_world_message("ObjectBegin\nShape \"disk\"\nObjectEnd"),
            "3:1: ObjectBegin: found 'Shape', expected the name of an object in quotes");
  EXPECT_EQ(pbrt_world_message("AttributeBegn\nShape \"disk\"\nAttributeEnd"),
            "2:1: found 'AttributeBegn', expected a directive, did you mean 'AttributeBegin'?");
  EXPECT_EQ(pbrt_world_message("AttributeBegin\nShape \"disk\"\nAttributeEdn"),
            "4:1: found 'AttributeEdn', expected a directive, did you mean 'AttributeEnd'?");
}

TEST(Errors_PbrtOneMessage, TypesThatAreMisspelledOrMissing) {
  EXPECT_EQ(pbrt_message("Integrator \"pth\"\nWorldBegin"),
            "1:12: 'pth' is no integrator, did you mean 'path'?");
  const auto medium = [](const std::string& type) {
    return pbrt_world_message("MakeNamedMedium \"f\" " + type +
                              "\nMediumInterface \"f\" \"\"\nShape \"sphere\"");
  };
  EXPECT_EQ(medium("\"string type\" \"homogenous\""),
            "2:17: 'homogenous' is no type of media, did you mean 'homogeneous'?");
  EXPECT_EQ(medium(""), "2:17: the medium 'f' has no type: expected \"string type\"");
  EXPECT_EQ(medium("\"string tipe\" \"homogeneous\""),
            "2:21: 'tipe' is not a parameter of MakeNamedMedium, did you mean 'type'?");
  EXPECT_EQ(medium("\"float type\" 1"), "2:21: 'type' is of type float, expected string");
  EXPECT_EQ(pbrt_world_message("MakeNamedMaterial \"m\" \"string tipe\" \"diffuse\" "
                               "\"rgb reflectance\" [ 1 1 1 ]"),
            "2:23: 'tipe' is not a parameter of MakeNamedMaterial, did you mean 'type'?");
  EXPECT_EQ(pbrt_world_message("MakeNamedMaterial \"m\" \"float type\" 1"),
            "2:23: 'type' is of type float, expected string");
}

TEST(Errors_PbrtOneMessage, ValuesThatAreWrongAreNotMissing) {
  EXPECT_EQ(pbrt_world_message("Shape \"trianglemesh\" \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ] "
                               "\"integer indices\" [ 0 1.5 2 ]"),
            "2:55: 'indices' has 1.5, expected integers of at least 0");
  EXPECT_EQ(pbrt_world_message("Shape \"plymesh\" \"texture filename\" \"x.ply\""),
            "2:17: 'filename' is of type texture, expected string");
  EXPECT_EQ(pbrt_world_message("Shape \"plymesh\" \"string filename\" [ \"x.ply\" \"y.ply\" ]"),
            "2:17: 'filename' has 2 values, expected 1");
  EXPECT_EQ(pbrt_world_message("LightSource \"projection\" \"float filename\" 3"),
            "2:26: 'filename' is of type float, expected string");
  EXPECT_EQ(pbrt_world_message("Texture \"t\" \"spectrum\" \"imagemap\" \"float filename\" 3\n"
                               "Material \"diffuse\" \"texture reflectance\" \"t\""),
            "2:35: 'filename' is of type float, expected string");
  EXPECT_EQ(
      pbrt_world_message("LightSource \"spot\" \"point from\" [ 0 0 1 ] \"point to\" [ 0 0 ]"),
      "2:43: 'to' has 2 values, expected 3");
  EXPECT_EQ(pbrt_world_message("Material \"mix\" \"float materials\" 3"),
            "2:16: 'materials' is of type float, expected string");
}

TEST(Errors_PbrtOneMessage, WhatIsInErrorHasNoValue) {
  EXPECT_EQ(pbrt_world_message("Texture \"e\" \"spectrum\" \"scale\" \"texture tex\" \"e\" "
                               "\"float scale\" 2\n"
                               "Material \"diffuse\" \"texture reflectance\" \"e\""),
            "2:32: textures are made of each other more than 64 deep: 'e' perhaps of itself");
  EXPECT_EQ(pbrt_world_message("Material \"dielectric\" \"spectrum eta\" \"no.spd\"").substr(0, 26),
            "2:23: 'eta' '" + test::pbrt_folder().substr(0, 13));
}

// As files say it that are included twice; what follows from it is not said then, either.
TEST(Errors_PbrtOneMessage, OfFilesThatAreReadTwice) {
  const auto twice = [](const std::string& file) {
    return pbrt_world_message("Include \"" + file + "\"\nInclude \"" + file + "\"");
  };
  EXPECT_EQ(twice("broken.pbrt"), "1:1: found 'Foo', expected a directive");
  EXPECT_EQ(twice("spot.pbrt"), "1:43: 'to' has 2 values, expected 3");
  EXPECT_EQ(twice("mesh.pbrt"), "1:55: 'indices' has -1, expected integers of at least 0");
}

}  // namespace
}  // namespace candela
