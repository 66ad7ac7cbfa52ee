// No ray leaves a closed mesh. At the level of the back ends: the meshes are not moved to the
// origin, as compile() would move them.
#include <atomic>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/accel/any_accel.h"
#include "renderer/base/parallel.h"
#include "tests/stress/closed_meshes.h"
#include "tests/stress/ray_random.h"
#include "tests/stress/row.h"

namespace candela {
namespace {

using namespace test;

// From within, in any direction; or towards a point of an edge, as nearly as floats allow.
Ray random_ray(const ClosedMesh& mesh, std::uint64_t index) {
  RayRandom random(index);
  const Vec3f origin = mesh.inside + random.in_cube() * mesh.radius;
  return {origin, Vec3f(random.direction()), infinity};
}

Ray edge_ray(const ClosedMesh& mesh, std::uint64_t index) {
  RayRandom random(index);
  const Vec3f origin = mesh.inside + random.in_cube() * mesh.radius;
  const auto& triangles = mesh.geometry.triangles;
  const auto& t = triangles[random.bits() % triangles.size()];
  const std::size_t corner = random.bits() % 3;
  const Vec3d a(mesh.geometry.positions[t[corner]]);
  const Vec3d b(mesh.geometry.positions[t[(corner + 1) % 3]]);
  const Vec3d target = a + (b - a) * static_cast<double>(random.uniform());
  return {origin, Vec3f(normalize(target - Vec3d(origin))), infinity};
}

using MakeRay = Ray (*)(const ClosedMesh&, std::uint64_t);

template <Accelerator A>
std::uint64_t escapes_of(const A& accelerator, const ClosedMesh& mesh, MakeRay make_ray,
                         std::uint64_t count) {
  constexpr std::uint64_t chunk = 1 << 16;
  std::atomic<std::uint64_t> escapes{0};
  with_threads(0, [&] {
    parallel_for((count + chunk - 1) / chunk, [&](std::size_t c) {
      std::uint64_t own = 0;
      for (std::uint64_t i = c * chunk; i < std::min(count, (c + 1) * chunk); ++i)
        own += !accelerator.intersect(make_ray(mesh, i)).is_hit();
      escapes += own;
    });
  });
  return escapes;
}

struct Escapes {
  std::uint64_t bvh = 0;
  std::uint64_t robust = 0;
  std::uint64_t faces = 0;  // robust, with a list of faces where there are few
  std::uint64_t fast = 0;
};

Escapes escapes_of(const ClosedMesh& mesh, const std::string& kind, MakeRay make_ray,
                   std::uint64_t count) {
  const Scene scene = scene_of(mesh);
  const Escapes escapes{escapes_of(BvhAccel(scene), mesh, make_ray, count),
                        escapes_of(EmbreeAccel(scene, {.robust = true}), mesh, make_ray, count),
                        escapes_of(EmbreeAccel(scene, {.faces = true}), mesh, make_ray, count),
                        escapes_of(EmbreeAccel(scene, {.robust = false}), mesh, make_ray, count)};
  add_row(mesh.name + ", " + kind, {{"rays", static_cast<double>(count)},
                                    {"own BVH", static_cast<double>(escapes.bvh)},
                                    {"Embree, robust", static_cast<double>(escapes.robust)},
                                    {"Embree and faces", static_cast<double>(escapes.faces)},
                                    {"Embree, not robust", static_cast<double>(escapes.fast)}});
  return escapes;
}

std::vector<ClosedMesh> all_meshes() {
  std::vector<ClosedMesh> meshes{closed_cornell_box(), icosphere(1), icosphere(5), box_of_slivers(),
                                 far_sphere()};
  if (auto bunny = closed_bunny()) meshes.push_back(std::move(*bunny));
  return meshes;
}

TEST(Stress_Watertight, TheMeshesAreClosed) {
  for (const ClosedMesh& mesh : all_meshes()) EXPECT_EQ(open_edges(mesh.geometry), 0u) << mesh.name;
}

TEST(Stress_Watertight, RandomRays) {
  for (const ClosedMesh& mesh : all_meshes()) {
    const Escapes escapes =
        escapes_of(mesh, "random", random_ray, is_heavy() ? 60'000'000 : 400'000);
    EXPECT_EQ(escapes.bvh, 0u) << mesh.name;
    EXPECT_EQ(escapes.robust, 0u) << mesh.name;
    EXPECT_EQ(escapes.faces, 0u) << mesh.name;
  }
}

// (Embree's robust mode lets one in a hundred million pass, by a vertex.)
TEST(Stress_Watertight, RaysAtEdges) {
  for (const ClosedMesh& mesh : all_meshes()) {
    const std::uint64_t count = is_heavy() ? 20'000'000 : 200'000;
    const Escapes escapes = escapes_of(mesh, "at edges", edge_ray, count);
    EXPECT_EQ(escapes.bvh, 0u) << mesh.name;
    EXPECT_LE(escapes.robust, count / 5'000'000) << mesh.name;
    EXPECT_LE(escapes.faces, count / 5'000'000) << mesh.name;
  }
}

}  // namespace
}  // namespace candela
