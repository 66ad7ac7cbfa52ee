#include "renderer/accel/probe_walks.h"

#include "renderer/accel/accelerator.h"
#include "renderer/math/frame.h"
#include "renderer/sampling/sampler.h"
#include "renderer/sampling/warp.h"

namespace candela {
namespace {

constexpr std::uint32_t walks = 256;
constexpr std::uint32_t most_bounces = 4;

// Geometric, on the side that the ray comes from; none of a triangle without area.
std::optional<Vec3f> normal_met(const Geometry& geometry, const Hit& hit, const Ray& ray) {
  Vec3f normal(0);
  if (geometry.spheres.empty()) {
    const auto& [a, b, c] = geometry.triangles[hit.triangle];
    const Vec3f corner = geometry.positions[a];
    normal = cross(geometry.positions[b] - corner, geometry.positions[c] - corner);
  } else {
    normal = ray.origin + hit.t * ray.direction - geometry.spheres[hit.triangle].centre;
  }
  const float squared = dot(normal, normal);
  if (!(squared > 0)) return {};
  normal /= std::sqrt(squared);
  return dot(normal, ray.direction) > 0 ? -normal : normal;
}

std::optional<Ray> next_ray(const Scene& scene, const Hit& hit, const Ray& ray, Vec2f u) {
  if (!hit.is_hit()) return {};
  const std::optional<Vec3f> normal = normal_met(scene.geometries[hit.geometry], hit, ray);
  if (!normal) return {};
  constexpr float off_the_surface = 1e-4f;
  const Vec3f position = ray.origin + hit.t * ray.direction;
  Vec3f direction = ray.direction;
  switch (scene.plain_models[hit.geometry]) {
    case PlainModel::Glass:
      break;
    case PlainModel::Mirror:
      direction -= 2 * dot(direction, *normal) * *normal;
      break;
    default:
      direction = frame_from_normal(*normal).to_world(square_to_cosine_hemisphere(u));
  }
  const float side = dot(direction, *normal) > 0 ? off_the_surface : -off_the_surface;
  return Ray{position + side * *normal, direction, infinity};
}

}  // namespace

void probe_walks(const Scene& scene, const std::function<Hit(const Ray&)>& trace) {
  if (scene.cameras.empty()) return;
  for (std::uint32_t walk = 0; walk < walks; ++walk) {
    const Sampler sampler(0, 0, 0, walk);
    std::optional<Ray> ray = scene.cameras.front().generate_ray(
        sampler.sample_2d(0, Dimension::Filter), sampler.sample_2d(0, Dimension::Lens));
    for (std::uint32_t bounce = 0; ray && is_traceable(*ray) && bounce <= most_bounces; ++bounce)
      ray = next_ray(scene, trace(*ray), *ray, sampler.sample_2d(bounce, Dimension::Direction));
  }
}

}  // namespace candela
