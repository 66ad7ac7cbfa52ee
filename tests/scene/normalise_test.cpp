#include "renderer/scene/normalise.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/scenes/description.h"

namespace candela {
namespace {

using namespace test;

TEST(Unit_Normalise, BringsTheHalfExtentToOne) {
  description::SceneDescription scene;
  add_mesh(scene, box({100, 200, 300}, {700, 250, 310}), add_material(scene, diffuse(Vec3d(0.5))));
  const Normalisation n = normalisation_of(scene);
  EXPECT_EQ(n.centre, Vec3d(400, 225, 305));
  EXPECT_EQ(n.scale, 1.0 / 512);
  EXPECT_EQ(n.to_file(Vec3f(0.5f, 0, 0)), Vec3d(656, 225, 305));
}

TEST(Unit_Normalise, OneFarOutlierDoesNotSpoilTheRest) {
  description::SceneDescription scene;
  const auto material = add_material(scene, diffuse(Vec3d(0.5)));
  add_mesh(scene, sphere({3, 0, 0}, 1, 3, false), material);
  add_mesh(scene, quad({1000000000.0, 1000000000.0, 1000000000.0}, {1, 0, 0}, {0, 0, 1}), material);
  const Normalisation n = normalisation_of(scene);
  EXPECT_NEAR(n.centre.x, 3, 0.1);
  EXPECT_GE(n.scale, 0.5);
  EXPECT_LE(n.scale, 2);
}

// More of its points lie at one end of an axis than single outliers may.
TEST(Unit_Normalise, OneFarLampDoesNotSpoilTheRest) {
  description::SceneDescription scene;
  const auto material = add_material(scene, diffuse(Vec3d(0.5)));
  add_mesh(scene, box({-0.5, 0, -0.5}, {0.5, 1, 0.5}), material);
  add_mesh(scene, quad({-3, 0, 3}, {6, 0, 0}, {0, 0, -6}), material);
  const Normalisation alone = normalisation_of(scene);
  description::Mesh ball;
  ball.sphere = description::Sphere{};
  for (const double distance : {1e6, 1e9, 1e30})
    for (const description::Mesh& lamp :
         {quad({0, 0, 0}, {0.005, 0, 0}, {0, 0, 0.005}), ball, sphere({0, 0, 0}, 0.005, 0)}) {
      description::SceneDescription lit = scene;
      add_mesh(lit, lamp, material,
               {Mat3d(distance), {0.5 * distance, 0.8 * distance, -2 * distance}});
      const Normalisation n = normalisation_of(lit);
      EXPECT_EQ(n.centre, alone.centre);
      EXPECT_EQ(n.scale, alone.scale);
    }
}

TEST(Unit_Normalise, ACrumbAboveAFloorIsNotTheScene) {
  description::SceneDescription scene;
  const auto material = add_material(scene, diffuse(Vec3d(0.5)));
  add_mesh(scene, quad({-10, 0, 10}, {20, 0, 0}, {0, 0, -20}), material);
  const double alone = normalisation_of(scene).scale;
  for (const double size : {1e-10, 1e-13, 1e-30}) {
    description::SceneDescription both = scene;
    add_mesh(both, quad({0, 2, 0}, {size, 0, 0}, {0, 0, size}), material);
    EXPECT_EQ(normalisation_of(both).scale, alone) << size;
  }
}

TEST(Unit_Normalise, APlateAboveAPlanetIs) {
  description::SceneDescription scene;
  const auto material = add_material(scene, diffuse(Vec3d(0.5)));
  add_mesh(scene, quad({0, 4e5, 0}, {0.1, 0, 0}, {0, 0, 0.1}), material);
  const double alone = normalisation_of(scene).scale;
  description::Mesh planet;
  planet.sphere = description::Sphere{.radius = 6.371e6};
  add_mesh(scene, planet, material, {Mat3d(1.0), {0, -6.371e6, 0}});
  EXPECT_EQ(normalisation_of(scene).scale, alone);
}

TEST(Unit_Normalise, ALargeFloorUnderASmallObjectIsNoOutlier) {
  description::SceneDescription scene;
  const auto material = add_material(scene, diffuse(Vec3d(0.5)));
  add_mesh(scene, sphere({0, 0, 0}, 1, 4, false), material);
  add_mesh(scene, quad({-40, -1, 40}, {80, 0, 0}, {0, 0, -80}), material);
  EXPECT_EQ(normalisation_of(scene).scale, 1.0 / 64);
}

// Instances whose box lies within the others' are stepped over; no corner that counts may be.
TEST(Unit_Normalise, ManyInstancesOfALargeMeshHaveTheBoxOfAllVertices) {
  description::SceneDescription scene;
  description::Mesh mesh = sphere({0, 0, 0}, 1, 5);
  ASSERT_GT(mesh.positions.size(), 8192u);
  mesh.positions[1] = {3, 0.5, 0};  // which a stride of two misses
  Bounds3d bounds;
  const auto handle = add_mesh(scene, mesh, add_material(scene, diffuse(Vec3d(0.5))));
  for (const Vec3d& p : mesh.positions) bounds.include(p);
  for (int i = 1; i < 60; ++i) {
    const double a = 0.7 * i;
    const Transform placed{
        Mat3d(std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a), 0, 0, 0, 1),
        Vec3d(10 * std::sin(1.3 * i), 10 * std::cos(2.1 * i), std::sin(3.0 * i))};
    add_instance(scene, handle, placed);
    for (const Vec3d& p : mesh.positions) bounds.include(placed.point(p));
  }
  const Normalisation n = normalisation_of(scene);
  EXPECT_EQ(n.centre, bounds.centre());
}

// Of so many instances few vertices each are sampled.
TEST(Unit_Normalise, NorDoAThousandOfASmallOneMissAVertex) {
  description::SceneDescription scene;
  description::Mesh mesh = sphere({0, 0, 0}, 1, 4);
  ASSERT_LT(mesh.positions.size(), 4096u);
  mesh.positions[1] = {30, 0, 0};
  const auto handle = add_mesh(scene, mesh, add_material(scene, diffuse(Vec3d(0.5))));
  for (int i = 1; i < 2048; ++i) add_instance(scene, handle, {});
  EXPECT_EQ(normalisation_of(scene).centre, Vec3d(14.5, 0, 0));
}

TEST(Unit_Normalise, NorDoOutliersOnSeveralAxesOfASmallOne) {
  description::SceneDescription scene;
  const auto material = add_material(scene, diffuse(Vec3d(0.5)));
  add_mesh(scene, quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}), material);
  const double alone = normalisation_of(scene).scale;
  const auto triangle_at = [](const Vec3d& p) {
    description::Mesh mesh;
    mesh.positions = {p, p + Vec3d(1, 0, 0), p + Vec3d(0, 1, 0)};
    mesh.triangles.push_back({0, 1, 2});
    return mesh;
  };
  add_mesh(scene, triangle_at({1e8, 0, 0}), material);
  add_mesh(scene, triangle_at({0, 1e8, 0}), material);
  EXPECT_GE(normalisation_of(scene).scale / alone, 0.5);
  EXPECT_LE(normalisation_of(scene).scale / alone, 2);
}

// Of few corners, and by sines and cosines: on each axis those between the outermost differ by
// rounding alone.
TEST(Unit_Normalise, PolygonsOfFewCornersHaveTheirSize) {
  for (const int count : {4, 8}) {
    description::Mesh polygon;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      polygon.positions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    }
    EXPECT_NEAR(normalisation_of(polygon).scale, 0.5, 0.25) << count;
    description::SceneDescription scene;
    add_mesh(scene, polygon, add_material(scene, diffuse(Vec3d(0.5))));
    EXPECT_NEAR(normalisation_of(scene).scale, 0.5, 0.25) << count;
  }
}

TEST(Unit_Normalise, EmptyAndPointLikeScenesHaveAUnit) {
  description::SceneDescription scene;
  EXPECT_EQ(normalisation_of(scene).scale, 1.0);
  const auto material = add_material(scene, diffuse(Vec3d(0.5)));
  add_mesh(scene, quad({5, 5, 5}, {0, 0, 0}, {0, 0, 0}), material);
  EXPECT_EQ(normalisation_of(scene).centre, Vec3d(5.0));
}

}  // namespace
}  // namespace candela
