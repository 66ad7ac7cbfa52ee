#include "renderer/scene/normalise.h"

#include <gtest/gtest.h>

#include "tests/scenes/describe.h"

namespace candela {
namespace {

using namespace test;

TEST(Unit_Normalise, BringsTheHalfExtentToOne) {
  description::SceneDescription scene;
  add_box(scene, add_material(scene, diffuse_material("a", Vec3d(0.5))), {100, 200, 300},
          {700, 250, 310}, false);
  const Normalisation n = normalisation_of(scene);
  EXPECT_EQ(n.centre, Vec3d(400, 225, 305));
  EXPECT_EQ(n.scale, 1.0 / 512);
  EXPECT_EQ(n.to_file(Vec3f(0.5f, 0, 0)), Vec3d(656, 225, 305));
}

TEST(Unit_Normalise, OneFarOutlierDoesNotSpoilTheRest) {
  description::SceneDescription scene;
  const auto material = add_material(scene, diffuse_material("a", Vec3d(0.5)));
  add_sphere(scene, material, {3, 0, 0}, 1, 3, false);
  add_quad(scene, material, {1e9, 1e9, 1e9}, {1e9 + 1, 1e9, 1e9}, {1e9, 1e9 + 1, 1e9},
           {1e9, 1e9, 1e9 + 1});
  const Normalisation n = normalisation_of(scene);
  EXPECT_NEAR(n.centre.x, 3, 0.1);
  EXPECT_GE(n.scale, 0.5);
  EXPECT_LE(n.scale, 2);
}

TEST(Unit_Normalise, ALargeFloorUnderASmallObjectIsNoOutlier) {
  description::SceneDescription scene;
  const auto material = add_material(scene, diffuse_material("a", Vec3d(0.5)));
  add_sphere(scene, material, {0, 0, 0}, 1, 4, false);
  add_quad(scene, material, {-40, -1, 40}, {40, -1, 40}, {40, -1, -40}, {-40, -1, -40});
  EXPECT_EQ(normalisation_of(scene).scale, 1.0 / 64);
}

TEST(Unit_Normalise, EmptyAndPointLikeScenesHaveAUnit) {
  description::SceneDescription scene;
  EXPECT_EQ(normalisation_of(scene).scale, 1.0);
  const auto material = add_material(scene, diffuse_material("a", Vec3d(0.5)));
  add_quad(scene, material, Vec3d(5.0), Vec3d(5.0), Vec3d(5.0), Vec3d(5.0));
  EXPECT_EQ(normalisation_of(scene).centre, Vec3d(5.0));
}

}  // namespace
}  // namespace candela
