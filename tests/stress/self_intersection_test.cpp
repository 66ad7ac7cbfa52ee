// Rays that leave a surface do not meet it again (acne), and do not fall through it (leaks), at any
// angle, size and place: the start is moved off the surface by the bound of its rounding error.
#include <atomic>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/base/parallel.h"
#include "renderer/geometry/surface_point.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/stress/disturb.h"
#include "tests/stress/ray_random.h"
#include "tests/stress/row.h"

namespace candela {
namespace {

using description::SceneDescription;
using namespace test;

// A convex surface, compiled: a ray that leaves it outwards meets nothing.
struct Convex {
  std::string name;
  SceneDescription scene;
  bool is_closed = true;  // a ray inwards meets its far side
  // Else its faces are so narrow that rounding of their vertices tilts them by more than the least
  // angles that are tried, and some of what is counted is really there.
  bool is_convex_to_rounding = true;
};

SceneDescription turned(SceneDescription scene) {
  set_camera(scene, {0, 0, 5}, {0, 0, 0});
  return rotated(scene, 0.7, {1, 2, 3});
}

SceneDescription scene_with(const description::Mesh& mesh, const Transform& placement = {}) {
  SceneDescription scene = empty_scene();
  add_mesh(scene, mesh, add_material(scene, diffuse(Vec3d(0.5))), placement);
  return scene;
}

// `count` by `count` squares in one plane.
description::Mesh flat_grid(int count) {
  description::Mesh mesh;
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < count; ++k) {
      const double side = 2.0 / count;
      const description::Mesh square =
          quad({-1 + i * side, 0, -1 + k * side}, {0, 0, side}, {side, 0, 0});
      mesh = mesh.positions.empty() ? square : merged(std::move(mesh), square);
    }
  return mesh;
}

// Two small instances near corners of a scene of size 1.
SceneDescription small_instances(const description::Mesh& mesh, double size) {
  SceneDescription scene = empty_scene();
  const auto grey = add_material(scene, diffuse(Vec3d(0.5)));
  const auto handle = add_mesh(scene, mesh, grey, {Mat3d(size), {0.7, 0.6, -0.8}});
  add_instance(scene, handle, {Mat3d(size), {-0.9, -0.5, 0.7}});
  return turned(scene);
}

std::vector<Convex> convex_surfaces() {
  std::vector<Convex> all = {
      {"plane", turned(scene_with(flat_grid(1))), false},
      {"plane of 200 triangles", turned(scene_with(flat_grid(10))), false},
      {"cube", turned(scene_with(box({-1, -1, -1}, {1, 1, 1})))},
      {"box 20,000 times as wide as thick", turned(scene_with(box({-1, -1e-4, -1}, {1, 0, 1}))),
       true, false},
      {"box 200 times as wide as thick", turned(scene_with(box({-1, -1e-2, -1}, {1, 0, 1})))},
      {"sphere of 80", turned(scene_with(sphere({0, 0, 0}, 1, 1, false)))},
      {"sphere of 20480", turned(scene_with(sphere({0, 0, 0}, 1, 5, false)))},
  };
  for (const double size : {1e-1, 1e-2, 1e-3}) {
    all.push_back({fmt::format("instanced cube, 1:{:g}", 1 / size),
                   small_instances(box({-1, -1, -1}, {1, 1, 1}), size)});
    all.push_back({fmt::format("instanced sphere, 1:{:g}", 1 / size),
                   small_instances(sphere({0, 0, 0}, 1, 3, false), size)});
  }
  all.push_back({"instanced cube, 1:10000", small_instances(box({-1, -1, -1}, {1, 1, 1}), 1e-4)});
  return all;
}

// 1 to 10^-6, evenly in its logarithm.
double grazing_sine(RayRandom& random) {
  return std::pow(10.0, -6.0 * static_cast<double>(random.uniform()));
}

// At this sine of the angle with the surface, in any direction along it.
Vec3d direction_at(double sine, const Vec3d& normal, RayRandom& random) {
  const Vec3d along = normalize(cross(normal, random.direction()));
  return along * std::sqrt(1 - sine * sine) + normal * sine;
}

struct Placed {
  const Geometry* geometry = nullptr;
  std::uint32_t triangle = 0;
  const Instance* instance = nullptr;
};

Placed random_triangle(const Scene& scene, RayRandom& random) {
  Placed placed;
  if (!scene.instances.empty())
    placed.instance = &scene.instances[random.bits() % scene.instances.size()];
  const Object& object =
      placed.instance ? scene.objects[placed.instance->object.index] : scene.world;
  placed.geometry = &scene.geometries[object.geometries.at(0).index];
  placed.triangle = random.bits() % static_cast<std::uint32_t>(placed.geometry->triangles.size());
  return placed;
}

Placed placed_of(const Scene& scene, const Hit& hit) {
  return {&scene.geometries[hit.geometry], hit.triangle, instance_of(scene, hit)};
}

using Corners = std::array<Vec3d, 3>;

Corners corners_of(const Placed& placed) {
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3f& p = placed.geometry->positions[placed.geometry->triangles[placed.triangle][k]];
    corners[k] = Vec3d(placed.instance ? placed.instance->point(p) : p);
  }
  return corners;
}

// A ray from outside that meets the triangle at a grazing angle.
Ray grazing_ray(const Corners& p, RayRandom& random) {
  const double a = 1 - std::sqrt(static_cast<double>(random.uniform()));
  const double b = (1 - a) * static_cast<double>(random.uniform());
  const Vec3d target = p[0] * a + p[1] * b + p[2] * (1 - a - b);
  const Vec3d normal = normalize(cross(p[1] - p[0], p[2] - p[0]));
  const Vec3d back = direction_at(grazing_sine(random), normal, random);
  const double distance = 2 * length(p[1] - p[0]);
  return {Vec3f(target + back * distance), Vec3f(-back), infinity};
}

// Nearer than `distance` to an edge of its triangle. There a ray inwards may leave over the edge at
// once: it has nothing to meet.
bool is_at_edge(const Corners& p, const Hit& hit, double distance) {
  const double twice_area = length(cross(p[1] - p[0], p[2] - p[0]));
  const std::array<double, 3> weights{1.0 - hit.u - hit.v, hit.u, hit.v};
  for (std::size_t k = 0; k < 3; ++k)
    if (weights[k] * twice_area < distance * length(p[(k + 1) % 3] - p[(k + 2) % 3])) return true;
  return false;
}

struct Outcome {
  std::atomic<std::uint64_t> rays{0};
  std::atomic<std::uint64_t> acne{0};
  std::atomic<std::uint64_t> leaks{0};
};

// One ray in, one out, one through.
template <Accelerator A>
void try_ray(const A& accelerator, const Convex& convex, const Scene& scene, std::uint64_t index,
             Outcome& outcome) {
  RayRandom random(index);
  const Ray in = grazing_ray(corners_of(random_triangle(scene, random)), random);
  const Hit hit = accelerator.intersect(in);
  if (!hit.is_hit()) return;  // passed over the edge by rounding
  const Instance* instance = instance_of(scene, hit);
  const SurfacePoint point =
      make_surface_point(scene.geometries[hit.geometry], instance, hit, -in.direction, false);
  if (!point.is_front) return;  // came in over an edge and met a far side from behind
  if (is_at_edge(corners_of(placed_of(scene, hit)), hit, 4 * point.offset)) return;
  const Vec3d normal(point.geometric_normal);
  const auto meets_itself = [&](const Vec3d& direction) {
    const Hit next = accelerator.intersect(spawn_ray(point, Vec3f(direction)));
    return next.is_hit() && next.instance == hit.instance;
  };
  ++outcome.rays;
  outcome.acne += meets_itself(direction_at(grazing_sine(random), normal, random));
  outcome.leaks +=
      meets_itself(direction_at(grazing_sine(random), -normal, random)) != convex.is_closed;
}

template <Accelerator A>
void expect_clean(const A& accelerator, const std::string& name, const Convex& convex,
                  const Scene& scene, bool is_promised = true) {
  const std::uint64_t chunks = is_heavy() ? 400 : 20;
  constexpr std::uint64_t chunk = 5000;
  Outcome outcome;
  with_threads(0, [&] {
    parallel_for(chunks, [&](std::size_t c) {
      for (std::uint64_t i = c * chunk; i < (c + 1) * chunk; ++i)
        try_ray(accelerator, convex, scene, i, outcome);
    });
  });
  EXPECT_GT(outcome.rays, chunks * chunk / 3) << convex.name;
  if (is_promised && convex.is_convex_to_rounding) {
    EXPECT_EQ(outcome.acne, 0u) << convex.name << ", " << name;
    EXPECT_EQ(outcome.leaks, 0u) << convex.name << ", " << name;
  }
  add_row(convex.name + ", " + name, {{"rays out and in", static_cast<double>(outcome.rays)},
                                      {"acne", static_cast<double>(outcome.acne)},
                                      {"leaks", static_cast<double>(outcome.leaks)}});
}

TEST(Stress_SelfIntersection, RaysLeaveConvexSurfaces) {
  for (const Convex& convex : convex_surfaces()) {
    const Scene scene = compiled(convex.scene, {});
    expect_clean(BvhAccel(scene), "own BVH", convex, scene);
    expect_clean(EmbreeAccel(scene, {.robust = true}), "Embree, robust", convex, scene);
    expect_clean(EmbreeAccel(scene, {.faces = true}), "Embree and faces", convex, scene);
    expect_clean(EmbreeAccel(scene, {.robust = false}), "Embree, not robust", convex, scene, false);
  }
}

}  // namespace
}  // namespace candela
