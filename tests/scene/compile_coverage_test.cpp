#include "renderer/scene/compile_coverage.h"

#include <gtest/gtest.h>

#include <random>

#include "renderer/accel/alpha_test.h"
#include "tests/image/crafted_files.h"
#include "tests/image/temporary_folder.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using namespace test;

description::MaterialHandle add_leaf(description::SceneDescription& scene,
                                     description::ImageHandle map, const Vec3d& colour) {
  const auto material = add_material(scene, diffuse(colour));
  scene.materials.back().opacity = {1, map, description::alpha_or_first};
  return material;
}

// Two cards in two materials that share a map, and an opaque one.
Scene leaves(const TemporaryFolder& folder) {
  description::SceneDescription scene = empty_scene();
  const std::string path = folder.put("leaf.png", crafted::png_rgba(64, 64, [](int x, int y, int) {
                                        return std::hypot(x - 32, y - 32) < 20 ? 255u : 0u;
                                      }));
  scene.images.push_back({path, Encoding::Linear, Wrap::Repeat, {}});
  const description::ImageHandle map(0);
  const description::Mesh card = quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  add_mesh(scene, card, add_leaf(scene, map, Vec3d(0.5)));
  add_mesh(scene, card, add_leaf(scene, map, Vec3d(0.2)), {Mat3d(1), {0, 0, 1}});
  add_mesh(scene, card, add_material(scene, diffuse(Vec3d(0.7))), {Mat3d(1), {0, 0, 2}});
  set_camera(scene, {0.5, 0.5, 5}, {0.5, 0.5, 0}, 40);
  return compiled(scene, {});
}

TEST(Unit_CompileCoverage, OneGridForEachMapThatVisibilityAsks) {
  const TemporaryFolder folder;
  const Scene scene = leaves(folder);
  ASSERT_EQ(scene.coverage_grids.size(), 1u);
  EXPECT_EQ(scene.materials[0].coverage_grid, Handle<CoverageGrid>(0));
  EXPECT_EQ(scene.materials[1].coverage_grid, Handle<CoverageGrid>(0));
  EXPECT_FALSE(scene.materials[2].coverage_grid);
}

TEST(Unit_CompileCoverage, OpacityIsTheSameWithAndWithoutTheGrid) {
  const TemporaryFolder folder;
  const Scene scene = leaves(folder);
  Material bare = scene.materials[0];
  bare.coverage_grid = {};
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(-1, 2);
  std::array<int, 3> seen{};  // clear, between, opaque
  for (int i = 0; i < 20000; ++i) {
    const Vec2f uv{uniform(random), uniform(random)};
    const float opacity = opacity_at(scene, scene.materials[0], {}, uv);
    ASSERT_EQ(opacity, opacity_at(scene, bare, {}, uv)) << uv.x << ' ' << uv.y;
    ++seen[opacity <= 0 ? 0 : opacity < 1 ? 1 : 2];
  }
  for (const int count : seen) EXPECT_GT(count, 100);
}

}  // namespace
}  // namespace candela
