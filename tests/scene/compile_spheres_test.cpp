// Spheres of a description in the compiled scene.
#include "renderer/scene/compile_spheres.h"

#include <map>

#include <gtest/gtest.h>

#include "renderer/geometry/surface_point.h"
#include "tests/scenes/description.h"
#include "tests/scenes/exact_sphere.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using namespace test;

Scene compiled_scene(const description::SceneDescription& scene) {
  return compiled(scene, settings_of(8, 1).options);
}

TEST(Unit_CompileSpheres, ThoseOfOneMaterialAreOneGeometry) {
  description::SceneDescription scene = empty_scene();
  const auto grey = add_material(scene, diffuse(Vec3d(0.5)));
  const auto lamp = add_material(scene, diffuse(Vec3d(0.5)), Vec3d(1.0));
  set_camera(scene, {0, 0, 5}, {0, 0, 0});
  add_mesh(scene, exact_sphere(1), grey, at_place({-3, 0, 0}));
  add_mesh(scene, exact_sphere(2), lamp, at_place({3, 0, 0}, 0.5));
  add_mesh(scene, exact_sphere(0.25, true), grey, at_place({3, 2, 0}));
  const Scene out = compiled_scene(scene);
  ASSERT_EQ(out.geometries.size(), 2u);
  ASSERT_EQ(out.geometries[0].spheres.size(), 2u);
  EXPECT_TRUE(out.geometries[0].spheres[1].faces_inwards);
  EXPECT_TRUE(out.features.spheres);
  ASSERT_EQ(out.lights.size(), 1u);
  EXPECT_EQ(out.lights[0].kind, LightKind::Sphere);
  // The box is from -4 to 4: a unit of 8.
  EXPECT_EQ(out.normalisation.scale, 0.125);
  EXPECT_EQ(out.geometries[0].spheres[0].radius, 0.125f);
  EXPECT_EQ(out.geometries[1].spheres[0].radius, 0.125f);
  EXPECT_NEAR(out.bounds.lower.x, -0.5, 1e-5);
  EXPECT_NEAR(out.bounds.upper.x, 0.5, 1e-5);
}

TEST(Unit_CompileSpheres, SharedOnesAreInstances) {
  description::SceneDescription scene = empty_scene();
  set_camera(scene, {0, 0, 5}, {0, 0, 0});
  const auto sphere = add_mesh(scene, exact_sphere(1e-6), add_material(scene, diffuse(Vec3d(0.5))),
                               at_place({}, 1e6));
  add_instance(scene, sphere, at_place({4, 0, 0}, 2e6));
  const Scene out = compiled_scene(scene);
  EXPECT_EQ(out.instances.size(), 2u);
  ASSERT_EQ(out.geometries.size(), 1u);
  EXPECT_GT(out.geometries[0].spheres.at(0).radius, 0.5f);  // in its own unit
  EXPECT_GT(out.instances[0].placing_error.x, 0.0f);
}

TEST(Unit_CompileSpheres, WhatCannotBeMetIsDropped) {
  description::SceneDescription scene = small_room();
  const auto clear = add_material(scene, diffuse(Vec3d(0.5)));
  scene.materials[clear.index].opacity.factor = 0;
  add_mesh(scene, exact_sphere(0.1), clear);
  add_mesh(scene, exact_sphere(1e-30), description::MaterialHandle(0));
  const Scene out = compiled_scene(scene);
  EXPECT_FALSE(out.features.spheres);
  std::map<std::string, std::uint64_t> dropped;
  for (const Dropped& reason : out.dropped) dropped[reason.what] = reason.count;
  EXPECT_EQ(dropped["spheres that are wholly clear"], 1u);
  EXPECT_EQ(dropped["spheres that are too small beside the scene"], 1u);
}

// pbrt's coordinates, and derivatives by central differences of the place over them.
TEST(Unit_SpherePoint, CoordinatesAndDerivatives) {
  Sphere sphere;
  sphere.centre = {1, 2, 3};
  sphere.radius = 2;
  sphere.x = {0, 1, 0};
  sphere.y = {0, 0, 1};
  sphere.z = {1, 0, 0};
  const auto place_of = [&](double u, double v) {
    const double phi = 2 * pi_double * u;
    const double theta = pi_double * (1 - v);
    const Vec3d own(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                    std::cos(theta));
    return Vec3d(sphere.centre) +
           2.0 * (Vec3d(sphere.x) * own.x + Vec3d(sphere.y) * own.y + Vec3d(sphere.z) * own.z);
  };
  for (const Vec2d& uv : {Vec2d(0.1, 0.2), Vec2d(0.6, 0.9), Vec2d(0.99, 0.5)}) {
    const double u = uv.x;
    const double v = uv.y;
    const Vec3d place = place_of(u, v);
    const Vec2f told = to_octahedron(place - Vec3d(sphere.centre));
    const Hit hit{.t = 1, .u = told.x, .v = told.y, .geometry = 0};
    const SurfacePoint point = make_sphere_point(sphere, nullptr, hit, Vec3f(0, 0, 1), true);
    EXPECT_NEAR(point.uv.x, u, 1e-6);
    EXPECT_NEAR(point.uv.y, v, 1e-6);
    EXPECT_LT(length(Vec3d(point.position) - place), 2e-6);
    const double h = 1e-4;
    EXPECT_LT(length(Vec3d(point.dpdu) - (place_of(u + h, v) - place_of(u - h, v)) / (2 * h)),
              1e-4);
    EXPECT_LT(length(Vec3d(point.dpdv) - (place_of(u, v + h) - place_of(u, v - h)) / (2 * h)),
              1e-4);
    EXPECT_GT(dot(cross(point.dpdu, point.dpdv), point.front_normal), 0.0f);
    EXPECT_TRUE(point.is_flat);
  }
  const Hit pole{.t = 1, .u = 1, .v = 0, .geometry = 0};  // +x of the world
  const SurfacePoint point = make_sphere_point(sphere, nullptr, pole, Vec3f(-1, 0, 0), true);
  EXPECT_EQ(point.uv, Vec2f(0, 1));
  EXPECT_EQ(point.dpdu, Vec3f(0));
  EXPECT_FALSE(point.is_front);
}

}  // namespace
}  // namespace candela
