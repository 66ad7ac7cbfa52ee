// Meshes that are broken, empty, repeated or seen edge on.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/scenes/description.h"
#include "tests/stress/row.h"
#include "tests/stress/undisturbed.h"

namespace candela {
namespace {

using description::SceneDescription;
using namespace test;

RenderSettings small() {
  return settings_of(32, is_heavy() ? 64 : 8);
}

std::uint64_t dropped(const Scene& scene, const std::string& what) {
  for (const Dropped& entry : scene.dropped)
    if (entry.what == what) return entry.count;
  return 0;
}

// Points, lines, and triangles of three equal indices among the room's own.
SceneDescription with_degenerate_triangles() {
  SceneDescription scene = small_room();
  for (description::Mesh& mesh : scene.meshes) {
    const auto own = mesh.triangles;
    for (const auto& [a, b, c] : own)
      mesh.triangles.insert(mesh.triangles.end(), {{a, a, a}, {a, b, b}, {c, a, c}});
  }
  return scene;
}

TEST(Stress_OddGeometry, TrianglesWithoutAreaChangeNothing) {
  expect_same_bits(renders_of("degenerate triangles", with_degenerate_triangles(), small(), 2),
                   renders_of("undisturbed", small_room(), small(), 2));
}

TEST(Stress_OddGeometry, EmptyMeshesChangeNothing) {
  SceneDescription scene = small_room();
  description::Mesh vertices_only = quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  vertices_only.triangles.clear();
  const auto white = description::MaterialHandle(0);
  const auto lamp = description::MaterialHandle(3);
  for (const auto material : {white, lamp})
    for (const description::Mesh& mesh : {description::Mesh{}, vertices_only}) {
      const auto handle = add_mesh(scene, mesh, material);
      if (material == white) add_instance(scene, handle, {});
    }
  expect_same_bits(renders_of("empty meshes", scene, small(), 2),
                   renders_of("undisturbed", small_room(), small(), 2));
}

// Every triangle again, right behind itself in the mesh. Which of two equal faces is hit decides
// nothing.
TEST(Stress_OddGeometry, DuplicateTrianglesAreWithinNoise) {
  SceneDescription scene = small_room();
  for (description::Mesh& mesh : scene.meshes) {
    if (scene.materials[mesh.materials[0].index].emission != Vec3d(0.0)) continue;
    const auto own = mesh.triangles;
    for (int times = 0; times < 3; ++times)
      mesh.triangles.insert(mesh.triangles.end(), own.begin(), own.end());
  }
  expect_within_noise(renders_of("each triangle four times", scene, small()),
                      renders_of("undisturbed", small_room(), small()));
}

// Finite as written, but beyond what rays can meet once the scene has its own unit. Both back ends
// would leave them out silently.
TEST(Stress_OddGeometry, TrianglesTooFarAwayAreCountedAndSaid) {
  for (const double distance : {1e25, 1e200}) {
    SceneDescription scene = small_room();
    const Vec3d far(-distance, -distance, -distance);
    add_mesh(scene, triangle(far, far * 1.5, far * Vec3d(1, 2, 3)), description::MaterialHandle(0));
    const Result<Scene> compiled = compile(scene, {});
    ASSERT_TRUE(compiled);
    EXPECT_EQ(dropped(*compiled, "triangles with vertices that are not finite or too far away"),
              1u);
    ASSERT_EQ(compiled.diagnostics.list().size(), 1u);
    EXPECT_EQ(compiled.diagnostics.list()[0].message,
              "1 triangles with vertices that are not finite or too far away are left out");
    expect_within_noise(renders_of(fmt::format("a triangle at {:g}", distance), scene, small()),
                        renders_of("undisturbed", small_room(), small()));
  }
}

// Numbers that are not finite are an error that counts them.
TEST(Stress_OddGeometry, VerticesThatAreNotFiniteAreCountedAndSaid) {
  SceneDescription scene = small_room();
  scene.meshes[0].positions[1].y = std::numeric_limits<double>::quiet_NaN();
  scene.meshes[0].positions[3].x = -std::numeric_limits<double>::infinity();
  const Result<Scene> compiled = compile(scene, {});
  ASSERT_FALSE(compiled);
  EXPECT_NE(compiled.diagnostics.list()[0].message.find("2 of 4 vertices"), std::string::npos)
      << compiled.diagnostics.list()[0].message;
}

// Copies of one ball in one place: each ray meets all of them at one distance.
SceneDescription with_balls(int count) {
  SceneDescription scene = small_room();
  const auto ball = add_mesh(scene, sphere({0, 0, 0}, 0.3, 2), description::MaterialHandle(0),
                             {Mat3d(1.0), {0.3, 0, 0.3}});
  for (int i = 1; i < count; ++i) add_instance(scene, ball, {Mat3d(1.0), {0.3, 0, 0.3}});
  return scene;
}

TEST(Stress_OddGeometry, InstancesOnTopOfEachOtherAreOne) {
  const int count = is_heavy() ? 100'000 : 10'000;
  const RenderSettings settings = settings_of(8, 1);
  expect_same_bits(renders_of(fmt::format("{} instances", count), with_balls(count), settings, 2),
                   renders_of("2 instances", with_balls(2), settings, 2));
}

// Camera, point light and sun within the plane of the floor, along its edges and diagonals, with
// components of both zeros.
TEST(Stress_OddGeometry, RaysInThePlaneOfAFaceAreHarmless) {
  for (const Vec3d& along :
       {Vec3d(1, 0, 0), Vec3d(-1, -0.0, -0.0), Vec3d(0, 0, -1), normalize(Vec3d(1, 0, -1))}) {
    SceneDescription scene = small_room();
    add_light(scene, description::PointLight{{0.5, -1, 0.5}, Vec3d(1.0)});
    add_light(scene, description::DirectionalLight{along, Vec3d(1.0)});
    set_camera(scene, Vec3d(0, -1, 0.75) - 0.5 * along, Vec3d(0, -1, 0.75), 60);
    RenderSettings settings = small();
    settings.options.filter = FilterKind::Box;
    settings.options.filter_radius = 0.0f;
    for (const auto accelerator :
         {AcceleratorKind::Auto, AcceleratorKind::Embree, AcceleratorKind::Bvh})
      for (const int size : {1, 33}) {
        settings.accelerator = accelerator;
        settings.options.width = settings.options.height = size;
        const RenderResult result = rendered(scene, settings);
        add_row(fmt::format("along ({:g}, {:g}, {:g}), {} pixels", along.x, along.y, along.z, size),
                {{"invalid samples", static_cast<double>(result.statistics.invalid_samples)}});
      }
  }
}

// The room on a ground of a hundred times its size, and on far larger ones.
SceneDescription on_ground(double half_size) {
  SceneDescription scene = small_room();
  add_mesh(scene,
           quad({-half_size, -1.01, -half_size}, {0, 0, 2 * half_size}, {2 * half_size, 0, 0}),
           description::MaterialHandle(0));
  add_light(scene, description::ConstantEnvironment{Vec3d(0.5), true});
  set_camera(scene, {0, 2, 8}, {0, -1, 2}, 40);
  return scene;
}

TEST(Stress_OddGeometry, AGroundOfAnySizeIsWithinNoise) {
  const Renders undisturbed = renders_of("100", on_ground(1e2), small());
  for (const double size : {1e3, 1e4, 1e5, 1e6, 1e9, 1e12, 1e15})
    expect_within_noise(renders_of(fmt::format("ground of {:g}", size), on_ground(size), small()),
                        undisturbed);
}

}  // namespace
}  // namespace candela
