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

}  // namespace
}  // namespace candela
