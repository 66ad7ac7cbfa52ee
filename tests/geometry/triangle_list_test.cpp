#include "renderer/geometry/triangle_list.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

TEST(Unit_TriangleList, CopiesAndPrefixesShareTheTriangles) {
  TriangleList part;
  {
    const TriangleList whole{{0, 1, 2}, {3, 4, 5}, {0, 2, 4}};
    const TriangleList copy = whole;
    part = copy.prefix(2);
    EXPECT_EQ(part.data(), whole.data());
    EXPECT_TRUE(whole.begins_with(part));
    EXPECT_FALSE(part.begins_with(whole));
  }
  EXPECT_EQ(part, (TriangleList{{0, 1, 2}, {3, 4, 5}})) << "and outlive the one they came from";
  EXPECT_NE(part, (TriangleList{{0, 1, 2}, {3, 4, 6}}));
  EXPECT_NE(part, (TriangleList{{0, 1, 2}}));
}

TEST(Unit_TriangleList, NothingIsLeftOfOneThatIsMoved) {
  TriangleList list{{0, 1, 2}};
  TriangleList moved = std::move(list);
  EXPECT_EQ(list, TriangleList());
  list = std::move(moved);
  EXPECT_EQ(moved, TriangleList());
  EXPECT_EQ(list, (TriangleList{{0, 1, 2}}));
}

TEST(Unit_TriangleList, WithoutTriangles) {
  const TriangleList none;
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.begin(), none.end());
  EXPECT_EQ(none, TriangleList(std::vector<TriangleCorners>{}));
  EXPECT_TRUE((TriangleList{{0, 1, 2}}).begins_with(none));
}

}  // namespace
}  // namespace candela
