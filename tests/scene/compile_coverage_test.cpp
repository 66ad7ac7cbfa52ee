#include "renderer/scene/compile_coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "renderer/accel/alpha_test.h"
#include "renderer/accel/embree_accel.h"
#include "tests/image/crafted_files.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/scenes/temporary_folder.h"

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

// Within Embree's callbacks nothing may fail: what they look at is decoded as trees are built.
TEST(Unit_CompileCoverage, BehindTexturesImagesAreDecodedBeforeRaysAsk) {
  const TemporaryFolder folder;
  description::SceneDescription scene = empty_scene();
  const std::string path =
      folder.put("half.png", crafted::png_rgba(8, 8, [](int, int, int) { return 128u; }));
  scene.images.push_back({path, Encoding::Linear, Wrap::Repeat, {}});
  const description::ColourInput image{Vec3d(1.0), description::ImageHandle(0), {}};
  const description::ColourInput half{Vec3d(0.5), {}, {}};
  scene.textures.push_back({"inner", {}, description::ProductTexture{image, half}});
  const description::ColourInput inner{Vec3d(1.0), {}, description::TextureHandle(0)};
  scene.textures.push_back({"outer", {}, description::ProductTexture{inner, inner}});
  const auto material = add_material(scene, diffuse(Vec3d(0.5)));
  scene.materials.back().opacity = {1, {}, 0, description::TextureHandle(1)};
  add_mesh(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), material);
  set_camera(scene, {0.5, 0.5, 5}, {0.5, 0.5, 0}, 40);
  const Scene made = compiled(scene, {});
  EXPECT_EQ(made.textures.decoded_bytes(), 0u);
  const EmbreeAccel accelerator(made);
  EXPECT_EQ(made.textures.decoded_bytes(), 8u * 8 * 4);
}

TEST(Unit_CompileCoverage, RaysPassTheSameWithAndWithoutTheGrid) {
  const TemporaryFolder folder;
  const Scene scene = leaves(folder);
  Scene bare = leaves(folder);
  for (Material& material : bare.materials) material.coverage_grid = {};
  const auto leaf = static_cast<std::uint32_t>(
      std::ranges::find_if(scene.geometries, &Geometry::has_cutouts) - scene.geometries.begin());
  ASSERT_EQ(scene.geometries.at(leaf).triangles.size(), 2u);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0, 1);
  constexpr std::size_t rays = 4;
  std::array<int, rays + 1> seen{};  // by how many of the rays pass
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const float u = uniform(random), v = uniform(random) * (1 - u);
    std::size_t passing = 0;
    for (std::size_t k = 0; k < rays; ++k) {
      const Vec3f origin{uniform(random), uniform(random), 1}, direction{0, 0, -1};
      const bool passes =
          is_transparent_at(scene, leaf, i % 2, Hit{}.instance, u, v, origin, direction);
      ASSERT_EQ(passes,
                is_transparent_at(bare, leaf, i % 2, Hit{}.instance, u, v, origin, direction))
          << u << ' ' << v;
      passing += passes ? 1 : 0;
    }
    ++seen[passing];
  }
  EXPECT_GT(std::ranges::min(seen), 100);
}

}  // namespace
}  // namespace candela
