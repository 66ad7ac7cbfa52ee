// What `candela info` gathers.
#include "tools/candela/scene_info.h"

#include <gtest/gtest.h>

#include "tests/scenes/soups.h"

namespace candela::cli {
namespace {

TEST(Unit_SceneInfo, CornersThatAreSharedAreCountedOnce) {
  const Geometry geometry = test::geometry_of(test::random_soup(1000, 0.1f, 1));
  Geometry copied = geometry;
  copied.triangles =
      std::vector<TriangleCorners>(geometry.triangles.begin(), geometry.triangles.end());
  Geometry shorter = geometry;
  shorter.triangles = geometry.triangles.prefix(900);
  const auto bytes = [](std::vector<Geometry> geometries) {
    return describe_scene({}, test::scene_of(std::move(geometries))).mesh_bytes;
  };
  EXPECT_EQ(bytes({geometry, copied}), bytes({geometry, geometry}) + 12000);
  EXPECT_EQ(bytes({geometry, shorter}), bytes({geometry, geometry}));
  EXPECT_EQ(bytes({shorter, geometry}), bytes({geometry, geometry}));
}

}  // namespace
}  // namespace candela::cli
