#include "tests/accel/ray_sets.h"

#include "renderer/accel/accelerator.h"
#include "renderer/math/bounds.h"

namespace candela::test {
namespace {

Bounds3f bounds_of(const Soup& soup) {
  Bounds3f bounds;
  for (const Triangle& triangle : soup)
    for (const Vec3f& vertex : triangle) bounds.include(vertex);
  return bounds;
}

// Makes rays of what `make` returns until there are enough that may be traced.
template <class Make>
std::vector<Ray> collect(std::size_t count, const Make& make) {
  std::vector<Ray> rays;
  for (std::size_t tries = 0; rays.size() < count && tries < 4 * count; ++tries) {
    const Ray ray = make(tries);
    if (is_traceable(ray)) rays.push_back(ray);
  }
  return rays;
}

struct Source {
  const Soup& soup;
  Bounds3f bounds;
  std::mt19937 random;

  Source(const Soup& s, std::uint32_t seed) : soup(s), bounds(bounds_of(s)), random(seed) {}
  const Triangle& triangle() { return soup[random() % soup.size()]; }
  Vec3f point_within(float enlargement) {
    return bounds.centre() + uniform_in_cube(random) * bounds.extent() * (0.5f * enlargement);
  }
  Vec3f point_on(const Triangle& t) {
    float u = uniform(random);
    float v = uniform(random);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    return t[0] * (1 - u - v) + t[1] * u + t[2] * v;
  }
};

Ray towards(const Vec3f& from, const Vec3f& to) {
  return {from, normalize(to - from), infinity};
}

}  // namespace

std::vector<Ray> random_rays(const Soup& soup, std::size_t count, std::uint32_t seed) {
  Source source(soup, seed);
  return collect(count, [&](std::size_t i) {
    const Vec3f origin = source.point_within(1.5f);
    const Vec3f target = i % 4 < 2 ? source.point_on(source.triangle()) : source.point_within(1);
    Ray ray = towards(origin, target);
    if (i % 2 == 0) ray.t_max = length(source.bounds.extent()) * uniform(source.random);
    return ray;
  });
}

std::vector<Ray> axis_rays(const Soup& soup, std::size_t count, std::uint32_t seed) {
  Source source(soup, seed);
  return collect(count, [&](std::size_t i) {
    Ray ray;
    ray.origin = source.point_within(1.1f);
    if (i % 2 == 0) {
      const Triangle& triangle = source.triangle();
      for (int axis = 0; axis < 3; ++axis) ray.origin[axis] = triangle[source.random() % 3][axis];
    }
    const std::uint32_t bits = static_cast<std::uint32_t>(source.random());
    ray.direction = {bits & 1 ? 0.0f : -0.0f, bits & 2 ? 0.0f : -0.0f, bits & 4 ? 0.0f : -0.0f};
    const auto axis = static_cast<int>(i % 3);
    ray.direction[axis] = bits & 8 ? 1.0f : -1.0f;
    ray.origin[axis] -= ray.direction[axis] * source.bounds.extent()[axis] * 0.7f;
    return ray;
  });
}

std::vector<Ray> in_plane_rays(const Soup& soup, std::size_t count, std::uint32_t seed) {
  Source source(soup, seed);
  return collect(count, [&](std::size_t) {
    const auto& [a, b, c] = source.triangle();
    const Vec3f e1 = b - a;
    const Vec3f e2 = c - a;
    const Vec2f from(3 * uniform(source.random) - 1, 3 * uniform(source.random) - 1);
    const Vec2f along(2 * uniform(source.random) - 1, 2 * uniform(source.random) - 1);
    return Ray{a + e1 * from.x + e2 * from.y, normalize(e1 * along.x + e2 * along.y), infinity};
  });
}

std::vector<Ray> edge_rays(const Soup& soup, std::size_t count, std::uint32_t seed) {
  Source source(soup, seed);
  return collect(count, [&](std::size_t i) {
    const Triangle& triangle = source.triangle();
    const std::size_t corner = source.random() % 3;
    const float along = i % 2 == 0 ? 0 : uniform(source.random);
    const Vec3f target = triangle[corner] * (1 - along) + triangle[(corner + 1) % 3] * along;
    return towards(source.point_within(1.5f), target);
  });
}

std::vector<Ray> surface_rays(const Soup& soup, std::size_t count, std::uint32_t seed) {
  Source source(soup, seed);
  return collect(count, [&](std::size_t) {
    const Vec3f direction = uniform_in_cube(source.random);
    return Ray{source.point_on(source.triangle()), normalize(direction), infinity};
  });
}

std::vector<Ray> rays_of_all_sets(const Soup& soup, std::size_t count) {
  std::vector<Ray> rays = random_rays(soup, count, 1);
  for (const auto& more : {axis_rays(soup, count, 2), in_plane_rays(soup, count, 3),
                           edge_rays(soup, count, 4), surface_rays(soup, count, 5)})
    rays.insert(rays.end(), more.begin(), more.end());
  return rays;
}

Sphere random_sphere(RayRandom& random) {
  Sphere sphere;
  sphere.centre = random.in_cube();
  sphere.radius = std::pow(10.0f, -5 * random.uniform());
  return sphere;
}

std::vector<Ray> sphere_rays(const std::vector<Sphere>& spheres, std::size_t count,
                             std::uint32_t seed) {
  RayRandom random(seed);
  std::vector<Ray> rays;
  while (rays.size() < count) {
    const Sphere& sphere = spheres[random.bits() % spheres.size()];
    const Vec3f side(random.direction());
    const float graze = std::pow(10.0f, -6 * random.uniform()) * (random.bits() % 2 ? 1.0f : -1.0f);
    const Vec3f limb = sphere.centre + side * (sphere.radius * (1 + graze));
    const Vec3f along = cross(side, Vec3f(random.direction()));
    const Vec3f origin = rays.size() % 3 == 0   ? sphere.centre + side * (0.5f * sphere.radius)
                         : rays.size() % 3 == 1 ? limb - along * (random.uniform() * 2)
                                                : random.in_cube() * 2.0f;
    const Vec3f direction = rays.size() % 3 == 2 ? limb - origin : along;
    const Ray ray{origin, direction, random.bits() % 2 ? infinity : 1.5f};
    if (is_traceable(ray)) rays.push_back(ray);
  }
  return rays;
}

}  // namespace candela::test
