// Spheres in both accelerators: where rays meet them, alone, among triangles, with holes and in
// instances, and that no ray meets the sphere it leaves.
#include <gtest/gtest.h>

#include "integrators/ray_bench/ray_bench.h"
#include "renderer/accel/sphere_hit.h"
#include "renderer/base/parallel.h"
#include "renderer/geometry/surface_point.h"
#include "renderer/scene/instance_errors.h"
#include "tests/accel/ray_sets.h"
#include "tests/scenes/soups.h"
#include "tests/stress/ray_random.h"

namespace candela {
namespace {

using test::random_sphere;
using test::RayRandom;

const auto always = [](float, float) { return true; };

// The nearer root in long double; negative where there is none.
long double nearest_root(const Sphere& sphere, const Ray& ray) {
  long double a = 0;
  long double b = 0;
  long double c = -static_cast<long double>(sphere.radius) * sphere.radius;
  for (int axis = 0; axis < 3; ++axis) {
    const long double d = ray.direction[axis];
    const long double o =
        static_cast<long double>(ray.origin[axis]) - static_cast<long double>(sphere.centre[axis]);
    a += d * d;
    b += o * d;
    c += o * o;
  }
  const long double discriminant = b * b - a * c;
  if (discriminant < 0) return -1;
  const long double q = -b - std::copysign(std::sqrt(discriminant), b);
  const long double low = std::min(q / a, c / q);
  return low > 0 ? low : std::max(q / a, c / q);
}

TEST(Unit_SphereHit, IsTheNearerRoot) {
  RayRandom random(1);
  int hits = 0;
  for (int i = 0; i < 200'000; ++i) {
    const Sphere sphere = random_sphere(random);
    const Vec3f origin = i % 4 == 0
                             ? sphere.centre + Vec3f(random.direction()) * (0.9f * sphere.radius)
                             : random.in_cube() * 3.0f;
    const Vec3f aim =
        sphere.centre + Vec3f(random.direction()) * (1.1f * sphere.radius * random.uniform());
    const Ray ray{origin, (aim - origin) * (0.1f + 3 * random.uniform()), infinity};
    const long double expected = nearest_root(sphere, ray);
    const SphereHit hit = intersect_sphere(sphere, ray, ray.t_max, always);
    if (hit.is_hit() != (expected > 0)) {
      // Only a limb to the last bits of double may be in doubt.
      const Vec3d o = Vec3d(ray.origin) - Vec3d(sphere.centre);
      const Vec3d d = normalize(Vec3d(ray.direction));
      EXPECT_NEAR(length(o - d * dot(o, d)) / static_cast<double>(sphere.radius), 1, 1e-6);
      continue;
    }
    if (!hit.is_hit()) continue;
    ++hits;
    EXPECT_NEAR(static_cast<double>(static_cast<long double>(hit.t) / expected), 1, 1e-6);
    const Vec3d met = Vec3d(ray.origin) + Vec3d(ray.direction) * static_cast<double>(expected);
    const Vec3d told = Vec3d(sphere.centre) +
                       Vec3d(from_octahedron({hit.u, hit.v})) * static_cast<double>(sphere.radius);
    EXPECT_LT(length(met - told), 1e-6 * static_cast<double>(sphere.radius));
  }
  EXPECT_GT(hits, 100'000);
}

TEST(Unit_SphereHit, RangesAndHoles) {
  const Sphere sphere;  // unit
  const Ray ray{{0, 0, -3}, {0, 0, 2}, infinity};
  EXPECT_EQ(intersect_sphere(sphere, ray, 10, always).t, 1);
  EXPECT_EQ(intersect_sphere(sphere, ray, 1, always).t, 1);
  EXPECT_FALSE(intersect_sphere(sphere, ray, 0.999f, always).is_hit());
  const auto upper = [](float u, float v) { return from_octahedron({u, v}).z > 0; };
  EXPECT_EQ(intersect_sphere(sphere, ray, 10, upper).t, 2);
  EXPECT_FALSE(intersect_sphere(sphere, ray, 1.9f, upper).is_hit());
  EXPECT_EQ(intersect_sphere(sphere, Ray{{0, 0, 0}, {0, 0, 1}, 9}, 9, always).t, 1);
  EXPECT_FALSE(intersect_sphere(sphere, Ray{{0, 0, 3}, {0, 0, 1}, 9}, 9, always).is_hit());
}

TEST(Unit_SphereHit, OctahedraKeepDirections) {
  RayRandom random(2);
  double worst = 0;
  for (int i = 0; i < 100'000; ++i) {
    const Vec3d d = random.direction();
    worst = std::max(worst, length(Vec3d(from_octahedron(to_octahedron(d))) - d));
  }
  for (const Vec3d& axis : {Vec3d(1, 0, 0), Vec3d(0, -1, 0), Vec3d(0, 0, 1), Vec3d(0, 0, -1)})
    EXPECT_EQ(Vec3d(from_octahedron(to_octahedron(axis))), axis);
  EXPECT_LT(worst, 0x1p-22);
}

// The geometry of many spheres of all sizes in the scene; triangles about them.
Scene scene_of_spheres(float opacity) {
  Scene scene = test::scene_of(test::random_soup(300, 0.2f, 5));
  if (opacity < 1) test::add_cutout(scene, test::random_soup(10, 0.2f, 6), opacity);
  Geometry geometry;
  geometry.material = scene.geometries.back().material;
  geometry.has_cutouts = opacity < 1;
  RayRandom random(3);
  for (int i = 0; i < 500; ++i) {
    Sphere sphere = random_sphere(random);
    sphere.radius *= 0.3f;
    geometry.spheres.push_back(sphere);
  }
  scene.world.geometries.emplace_back(scene.geometries.size());
  scene.geometries.push_back(std::move(geometry));
  return scene;
}

void add_placed_spheres(Scene& scene) {
  Geometry geometry;
  geometry.material = scene.geometries[0].material;
  geometry.spheres = {{{0.2f, 0.1f, 0}, 0.5f}, {{-0.7f, 0, 0.3f}, 0.2f}};
  Object object;
  object.geometries.emplace_back(scene.geometries.size());
  scene.geometries.push_back(std::move(geometry));
  scene.objects.push_back(object);
  const auto place = [&](const Instance& instance) {
    scene.instances.push_back(instance);
    scene.instances.back().object = ObjectHandle(scene.objects.size() - 1);
  };
  place(test::placement({0.3f, 0, 0}, {0, 0.3f, 0}, {0, 0, 0.3f}, {0.5f, 0.4f, -0.2f}));
  place(test::placement({0, 0.2f, 0}, {0.2f, 0, 0}, {0, 0, 0.2f}, {-0.5f, 0, 0.6f}));  // mirrored
}

std::vector<Ray> rays_about(const Scene& scene, std::size_t count, std::uint32_t seed) {
  std::vector<Sphere> spheres;
  for (const Geometry& geometry : scene.geometries)
    spheres.insert(spheres.end(), geometry.spheres.begin(), geometry.spheres.end());
  return test::sphere_rays(spheres, count, seed);
}

void expect_agreement(const Scene& scene) {
  with_threads(0, [&] {
    const EmbreeAccel embree(scene);
    const BvhAccel bvh(scene);
    const std::vector<Ray> rays = rays_about(scene, 100'000, 4);
    for (const bool is_shadow : {false, true}) {
      const AgreementCounts counts = count_agreement(scene, embree, bvh, rays, is_shadow);
      EXPECT_EQ(counts.disagreeing, 0u);
      EXPECT_LT(counts.at_edge, counts.rays / 100);
    }
  });
}

TEST(Agreement_Spheres, BothAcceleratorsMeetTheSame) {
  expect_agreement(scene_of_spheres(1));
}

TEST(Agreement_Spheres, WithHoles) {
  expect_agreement(scene_of_spheres(0.5f));
}

TEST(Agreement_Spheres, InInstances) {
  Scene scene = scene_of_spheres(1);
  add_placed_spheres(scene);
  expect_agreement(scene);
}

bool are_same(const Hit& a, const Hit& b) {
  return a.t == b.t && a.u == b.u && a.v == b.v && a.geometry == b.geometry &&
         a.triangle == b.triangle && a.instance == b.instance;
}

// Spheres alone: to the bit, as single rays and as packets.
TEST(Agreement_Spheres, TheSameBitsWhereThereAreNoTriangles) {
  for (const float opacity : {1.0f, 0.5f}) {
    Scene scene = scene_of_spheres(opacity);
    scene.world.geometries = {GeometryHandle(scene.geometries.size() - 1)};
    const EmbreeAccel embree(scene);
    const BvhAccel bvh(scene);
    const std::vector<Ray> rays = rays_about(scene, 64'000, 7);
    std::size_t hits = 0;
    for (std::size_t i = 0; i + block_size <= rays.size(); i += block_size) {
      RayBlock block;
      for (std::size_t lane = 0; lane < block_size; ++lane) block.set(lane, rays[i + lane]);
      const HitBlock found = embree.intersect(block, all_lanes, Coherence::Coherent);
      const LaneMask occluded = embree.occluded(block, all_lanes);
      for (std::size_t lane = 0; lane < block_size; ++lane) {
        const Hit expected = bvh.intersect(block[lane]);
        hits += expected.is_hit();
        ASSERT_TRUE(are_same(embree.intersect(block[lane]), expected));
        ASSERT_TRUE(are_same(found[lane], expected));
        ASSERT_EQ((occluded >> lane & 1) != 0, expected.is_hit());
        ASSERT_EQ(embree.occluded(block[lane]), expected.is_hit());
      }
    }
    EXPECT_GT(hits, rays.size() / 4);
  }
}

struct Escape {
  std::size_t met_again = 0;  // rays that left to the outside
  std::size_t lost = 0;       // rays to the inside that did not meet the far side where it is
};

// Rays from a point of the only sphere, at sines from 1 to 10^-6 with it.
template <class A>
Escape escape(const Scene& scene, const A& accelerator, std::uint32_t seed) {
  RayRandom random(seed);
  const Instance* instance = scene.instances.empty() ? nullptr : &scene.instances[0];
  const Geometry& geometry = scene.geometries[0];
  const double radius = static_cast<double>(geometry.spheres[0].radius) *
                        (instance ? static_cast<double>(length(instance->x)) : 1.0);
  Escape result;
  for (int i = 0; i < 4'000; ++i) {
    const Vec2f place = to_octahedron(random.direction());
    const Hit hit{.t = 1, .u = place.x, .v = place.y, .geometry = 0};
    const double sine = std::pow(10.0, -6.0 * static_cast<double>(random.uniform()));
    SurfacePoint point = make_surface_point(geometry, instance, hit, Vec3f(0, 0, 1), false);
    if (!point.is_front) point.geometric_normal = -point.geometric_normal;
    const Vec3d normal(point.geometric_normal);
    const Vec3d along = normalize(cross(normal, random.direction()));
    const Vec3f out(normalize(along * std::sqrt(1 - sine * sine) + normal * sine));
    const Vec3f in(normalize(along * std::sqrt(1 - sine * sine) - normal * sine));
    if (dot(out, point.geometric_normal) > 0)
      result.met_again += accelerator.intersect(spawn_ray(point, out)).is_hit();
    if (!(dot(in, point.geometric_normal) < 0)) continue;
    const Hit far = accelerator.intersect(spawn_ray(point, in));
    // From an origin a little below the surface: the chord is as long as that makes it.
    const double depth = 3 * static_cast<double>(point.offset) / radius;
    const double longest = radius * (sine + std::sqrt(sine * sine + 2 * depth)) + radius * 1e-6;
    if (!far.is_hit() || static_cast<double>(far.t) > longest) ++result.lost;
  }
  return result;
}

Scene scene_of_one(const Sphere& sphere, const Instance* placed) {
  Scene scene;
  scene.materials.emplace_back();
  Geometry geometry;
  geometry.material = MaterialHandle(0);
  geometry.spheres = {sphere};
  scene.geometries.push_back(geometry);
  Object object;
  object.geometries.emplace_back(0);
  if (placed == nullptr) {
    scene.world = object;
    return scene;
  }
  scene.objects.push_back(object);
  scene.instances.push_back(*placed);
  scene.instances[0].object = ObjectHandle(0);
  Bounds3f box;
  box.include(sphere.centre - Vec3f(sphere.radius));
  box.include(sphere.centre + Vec3f(sphere.radius));
  set_errors(scene.instances[0], box);
  return scene;
}

void expect_no_escape(const Scene& scene, std::uint32_t seed) {
  const Escape embree = escape(scene, EmbreeAccel(scene), seed);
  const Escape bvh = escape(scene, BvhAccel(scene), seed);
  const Sphere& sphere = scene.geometries[0].spheres[0];
  EXPECT_EQ(embree.met_again, 0u) << sphere.radius;
  EXPECT_EQ(bvh.met_again, 0u) << sphere.radius;
  EXPECT_EQ(embree.lost, 0u) << sphere.radius;
  EXPECT_EQ(bvh.lost, 0u) << sphere.radius;
}

TEST(Stress_Spheres, NoRayMeetsTheSphereThatItLeft) {
  RayRandom random(8);
  for (std::uint32_t i = 0; i < 16; ++i)
    expect_no_escape(scene_of_one(random_sphere(random), nullptr), i);
}

// Of a negative determinant: what is outside stays there.
Instance mirrored(Instance instance) {
  instance.normal_x = -instance.normal_x;
  instance.normal_y = -instance.normal_y;
  instance.normal_z = -instance.normal_z;
  return instance;
}

TEST(Stress_Spheres, NorInInstances) {
  RayRandom random(9);
  for (const float size : {1.0f, 0.1f, 0.01f}) {
    const Instance turned =
        mirrored(test::placement(Vec3f(0.6f, 0.8f, 0) * size, Vec3f(-0.8f, 0.6f, 0) * size,
                                 Vec3f(0, 0, -1) * size, {0.7f, 0.6f, -0.8f}));
    for (std::uint32_t i = 0; i < 3; ++i) {
      Sphere sphere;
      sphere.centre = random.in_cube() * 0.3f;
      sphere.radius = 0.5f;
      expect_no_escape(scene_of_one(sphere, &turned), i);
    }
  }
}

}  // namespace
}  // namespace candela
