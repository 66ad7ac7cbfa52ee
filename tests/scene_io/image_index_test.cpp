#include "scene_io/image_index.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

using namespace description;

TEST(Unit_ImageIndex, AddsEachImageOnce) {
  SceneDescription scene;
  ImageIndex index;
  const Image plain{"a.png", Encoding::Srgb, Wrap::Repeat, {}};
  const Image linear{"a.png", Encoding::Linear, Wrap::Repeat, {}};
  const Image clamped{"a.png", Encoding::Srgb, Wrap::Clamp, {}};
  EXPECT_EQ(index.add(plain, scene), ImageHandle(0));
  EXPECT_EQ(index.add(linear, scene), ImageHandle(1));
  EXPECT_EQ(index.add(clamped, scene), ImageHandle(2));
  EXPECT_EQ(index.add(plain, scene), ImageHandle(0));
  // What others add is found as well.
  scene.images.push_back({"b.png", Encoding::Srgb, Wrap::Repeat, {}});
  EXPECT_EQ(index.add({"b.png", Encoding::Srgb, Wrap::Repeat, {}}, scene), ImageHandle(3));
  EXPECT_EQ(index.add({"c.png", Encoding::Srgb, Wrap::Repeat, {}}, scene), ImageHandle(4));
  EXPECT_EQ(scene.images.size(), 5u);
}

}  // namespace
}  // namespace candela
