#include "scene_io/pbrt/write/write_context.h"

#include <gtest/gtest.h>

namespace candela::pbrt {
namespace {

TEST(Unit_WriteContext, StemsAreNamesWithoutTheirExtensions) {
  EXPECT_EQ(stem_of("a/white oak.yaml"), "white_oak");
  EXPECT_EQ(stem_of("a/white_oak.yaml.gz"), "white_oak");
  EXPECT_EQ(stem_of("C:\\meshes\\ball.ply.GZ"), "ball");
  EXPECT_EQ(stem_of("a/ball.1.ply"), "ball_1");
  EXPECT_EQ(stem_of(""), "unnamed");
}

}  // namespace
}  // namespace candela::pbrt
