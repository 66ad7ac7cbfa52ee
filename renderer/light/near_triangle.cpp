#include "renderer/light/near_triangle.h"

#include "renderer/light/cosine_warp.h"
#include "renderer/sampling/spherical_triangle.h"

namespace candela {
namespace {

// Down to here a spherical triangle is known; less than this no picture shows.
constexpr float least_solid_angle = 1e-12f;

bool is_near_triangle(const Light& light, const Vec3f& from) {
  const Vec3f middle = light.position + (light.edge1 + light.edge2) * (1.0f / 3);
  const Vec3f to_middle = middle - from;
  return dot(to_middle, to_middle) < light.triangle_near_distance2;
}

SphericalTriangle seen_from(const Light& light, const Vec3f& from) {
  return make_spherical_triangle(Vec3d(light.position) - Vec3d(from), Vec3d(light.edge1),
                                 Vec3d(light.edge2));
}

// The square's side u.y = 0 is vertex 0, the corners of the other are vertices 1 and 2.
std::optional<BilinearDensity> warp_of(const Light& light, const Vec3f& from, const Vec3f& normal) {
  const Vec3f corner = light.position - from;
  const auto along = [&](int axis) {
    return corner[axis] + Float4{0, 0, light.edge1[axis], light.edge2[axis]};
  };
  return cosine_warp({along(0), along(1), along(2)}, normal);
}

}  // namespace

NearPlace sample_near_triangle(const Light& light, const Vec3f& from, const Vec3f& normal,
                               Vec2f u) {
  if (!is_near_triangle(light, from)) return {.weights = square_to_triangle(u)};
  const std::optional<BilinearDensity> warp = warp_of(light, from, normal);
  if (!warp) return {.is_seen = false};
  const SphericalTriangle triangle = seen_from(light, from);
  if (!(triangle.solid_angle > least_solid_angle)) return {.weights = square_to_triangle(u)};
  const Vec2f warped = warp->sample(u);
  return {.weights = Vec2f(triangle.point(warped)), .pdf = warp->at(warped) / triangle.solid_angle};
}

float near_triangle_pdf(const Light& light, const Vec3f& from, const Vec3f& normal, const Vec3f& wi,
                        float distance) {
  if (!is_near_triangle(light, from)) return triangle_light_pdf(light, wi, distance);
  const std::optional<BilinearDensity> warp = warp_of(light, from, normal);
  if (!warp) return 0;
  const SphericalTriangle triangle = seen_from(light, from);
  if (!(triangle.solid_angle > least_solid_angle)) return triangle_light_pdf(light, wi, distance);
  return warp->at(triangle.place_of(Vec3d(wi))) / triangle.solid_angle;
}

}  // namespace candela
