#include "renderer/scene/compile_quad_lights.h"

#include <optional>

#include "renderer/light/make_light.h"

namespace candela {
namespace {

// The corners, in an order such that the first triangle is 0 1 3 and the second 2 3 1.
using Corners = std::array<Vec3f, 4>;

std::array<Vec3f, 3> vertices_of(const Scene& scene, const Light& light) {
  const Geometry& geometry = scene.geometries[light.geometry];
  const auto& index = geometry.triangles[light.triangle];
  return {geometry.positions[index[0]], geometry.positions[index[1]], geometry.positions[index[2]]};
}

// Of two triangles with one winding and a common edge.
std::optional<Corners> common_corners(const std::array<Vec3f, 3>& a,
                                      const std::array<Vec3f, 3>& b) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (a[(i + 1) % 3] == b[(j + 2) % 3] && a[(i + 2) % 3] == b[(j + 1) % 3])
        return Corners{a[i], a[(i + 1) % 3], b[j], a[(i + 2) % 3]};
  return std::nullopt;
}

bool may_pair(const Light& a, const Light& b) {
  return a.kind == LightKind::Triangle && b.kind == LightKind::Triangle &&
         a.geometry == b.geometry && a.area > 0 && b.area > 0;
}

std::optional<Light> quad_of(const Scene& scene, const Light& a, const Light& b,
                             bool by_solid_angle) {
  if (!may_pair(a, b)) return std::nullopt;
  const std::optional<Corners> corners =
      common_corners(vertices_of(scene, a), vertices_of(scene, b));
  if (!corners) return std::nullopt;
  std::optional<Light> quad =
      make_quad_light(*corners, a.emission, a.emits_both_sides, by_solid_angle);
  if (by_solid_angle && quad && !(quad->near_distance2 > 0)) return std::nullopt;
  if (quad) quad->geometry = a.geometry;
  return quad;
}

}  // namespace

void add_quad_lights(Scene& scene, bool by_solid_angle) {
  const std::size_t count = scene.lights.size();
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const std::optional<Light> quad =
        quad_of(scene, scene.lights[i], scene.lights[i + 1], by_solid_angle);
    if (!quad) continue;
    scene.lights[i].quad = scene.lights[i + 1].quad =
        static_cast<std::uint32_t>(scene.lights.size());
    scene.lights.push_back(*quad);
    ++i;
  }
}

void sample_triangles_by_solid_angle(Scene& scene) {
  for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
    Light& light = scene.lights[i];
    const bool is_triangle =
        light.kind == LightKind::Triangle || light.kind == LightKind::TexturedTriangle;
    if (is_triangle && light.area > 0 && light.quad == Light::none) sample_by_solid_angle(light, i);
  }
}

}  // namespace candela
