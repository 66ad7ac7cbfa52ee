#include "renderer/light/make_light.h"

#include <algorithm>
#include <limits>

namespace candela {
namespace {

// 1 - cos(angle) = 2 sin^2(angle / 2), without cancellation.
float versine(double angle_radians) {
  return static_cast<float>(2 * square(std::sin(0.5 * angle_radians)));
}

// The products of floats are exact in double, so even needles have a normal.
Vec3f unit_normal(const Vec3f& edge1, const Vec3f& edge2, double area) {
  return Vec3f(cross(Vec3d(edge1), Vec3d(edge2)) * (0.5 / area));
}

// Below the normal floats 1 / area overflows or is flushed to 0.
float usable_area(double area) {
  const bool is_usable =
      area >= std::numeric_limits<float>::min() && area <= std::numeric_limits<float>::max();
  return is_usable ? static_cast<float>(area) : 0.0f;
}

// To what floats can tell of edges that were rounded; a skew of 1e-5 changes densities by as much.
bool is_rectangle(const Light& quad) {
  const Vec3d edge1(quad.edge1);
  const Vec3d edge2(quad.edge2);
  return std::abs(dot(edge1, edge2)) <= 1e-5 * length(edge1) * length(edge2);
}

// Where a lamp begins to be sampled by solid angle: area over squared distance from its middle.
// Less brings less than it costs (docs/decisions.md).
constexpr float near_solid_angle = 1.5f;

// Long lamps are as near beside their ends, which lie `beyond` those of one that is not long.
float near_distance2_of(float area, float beyond) {
  return square(std::sqrt(area / near_solid_angle) + beyond);
}

}  // namespace

Light make_point_light(const Vec3f& position, const Rgb& intensity) {
  Light light;
  light.kind = LightKind::Point;
  light.position = position;
  light.emission = intensity;
  return light;
}

Light make_spot_light(const Vec3f& position, const Vec3d& axis, const Rgb& intensity,
                      double inner_angle_radians, double outer_angle_radians) {
  Light light = make_point_light(position, intensity);
  light.kind = LightKind::Spot;
  light.edge1 = Vec3f(normalize(axis));
  light.versine_inner = versine(inner_angle_radians);
  light.versine_outer = versine(outer_angle_radians);
  return light;
}

Light make_goniometric_light(const Vec3f& position, const Mat3d& world_from_map,
                             const Rgb& intensity, TextureHandle texture) {
  Light light = make_point_light(position, intensity);
  light.kind = LightKind::Goniometric;
  light.edge1 = Vec3f(world_from_map[0]);
  light.edge2 = Vec3f(world_from_map[1]);
  light.normal = Vec3f(world_from_map[2]);
  light.texture = texture;
  return light;
}

Light make_projection_light(const Vec3f& position, const Mat3d& world_from_map,
                            const Vec2d& half_sides, const Rgb& intensity, TextureHandle texture) {
  Light light = make_goniometric_light(position, world_from_map, intensity, texture);
  light.kind = LightKind::Projection;
  light.edge1 = Vec3f(world_from_map[0] / half_sides.x);
  light.edge2 = Vec3f(world_from_map[1] / half_sides.y);
  return light;
}

Light make_directional_light(const Vec3d& to_light, const Rgb& irradiance) {
  Light light;
  light.kind = LightKind::Directional;
  light.position = Vec3f(normalize(to_light));
  light.emission = irradiance;
  return light;
}

Light make_triangle_light(const std::array<Vec3f, 3>& vertices, const Rgb& radiance,
                          bool emits_both_sides) {
  Light light;
  light.kind = LightKind::Triangle;
  light.emits_both_sides = emits_both_sides;
  light.position = vertices[0];
  light.edge1 = vertices[1] - vertices[0];
  light.edge2 = vertices[2] - vertices[0];
  light.emission = radiance;
  const double area = 0.5 * length(cross(Vec3d(light.edge1), Vec3d(light.edge2)));
  light.area = usable_area(area);
  if (light.area > 0) light.normal = unit_normal(light.edge1, light.edge2, area);
  // The edges carry the rounding of v1 - v0, then a product and two sums round again.
  const Vec3f error =
      gamma_bound(5) * (glm::abs(light.position) + glm::abs(light.edge1) + glm::abs(light.edge2));
  light.offset = dot(glm::abs(light.normal), error);
  return light;
}

Light make_sphere_light(const Sphere& sphere, const Rgb& radiance, bool emits_both_sides) {
  Light light;
  light.kind = LightKind::Sphere;
  light.emits_both_sides = emits_both_sides;
  light.faces_inwards = sphere.faces_inwards;
  light.position = sphere.centre;
  light.edge1 = Vec3f(sphere.radius, 0, 0);
  light.emission = radiance;
  light.area = usable_area(4 * pi_double * square(static_cast<double>(sphere.radius)));
  // |n| . (|centre| + |n| radius), where the unit n turns to any side.
  light.offset = gamma_bound(8) * (length(sphere.centre) + sphere.radius);
  return light;
}

std::optional<Light> make_quad_light(const std::array<Vec3f, 4>& corners, const Rgb& radiance,
                                     bool emits_both_sides, bool by_solid_angle) {
  Vec3f gap = corners[1] + corners[3] - (corners[0] + corners[2]);
  Light light =
      make_triangle_light({corners[0], corners[1], corners[3]}, radiance, emits_both_sides);
  light.length1 = length(light.edge1);
  light.length2 = length(light.edge2);
  constexpr float most_gap = 4e-6f;  // of the shorter edge: as large is the error of densities
  if (!(light.area > 0) || !(length(gap) <= most_gap * std::min(light.length1, light.length2)))
    return std::nullopt;
  light.kind = LightKind::Quad;
  light.area *= 2;
  light.offset += std::abs(dot(light.normal, gap));
  if (by_solid_angle && is_rectangle(light))
    light.near_distance2 =
        near_distance2_of(light.area, 0.5f * std::abs(light.length1 - light.length2));
  return light;
}

void sample_by_solid_angle(Light& triangle, std::uint32_t index) {
  if (triangle.kind == LightKind::Triangle) triangle.kind = LightKind::NearTriangle;
  triangle.quad = index;
  triangle.near_distance2 = std::numeric_limits<float>::infinity();
  const float longest = std::max(
      {length(triangle.edge1), length(triangle.edge2), length(triangle.edge1 - triangle.edge2)});
  const float height = 2 * triangle.area / longest;
  triangle.triangle_near_distance2 =
      near_distance2_of(triangle.area, (longest - height) * (2.0f / 3));
}

Light make_environment_light() {
  Light light;
  light.kind = LightKind::Environment;
  return light;
}

}  // namespace candela
