#include "scene_io/pbrt/mesh_areas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "renderer/math/constants.h"

namespace candela::pbrt {

Areas areas_of(const description::Mesh& mesh, std::span<const std::uint32_t> triangles,
               const Transform& world_from_object) {
  Areas areas;
  areas.triangle_count = triangles.size();
  for (const std::uint32_t triangle : triangles) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    const Vec3d edge1 = world_from_object.vector(mesh.positions[b] - mesh.positions[a]);
    const Vec3d edge2 = world_from_object.vector(mesh.positions[c] - mesh.positions[a]);
    areas.surface += length(cross(edge1, edge2)) / 2;
    if (mesh.uvs.empty()) continue;
    const Vec2d uv1 = Vec2d(mesh.uvs[b]) - Vec2d(mesh.uvs[a]);
    const Vec2d uv2 = Vec2d(mesh.uvs[c]) - Vec2d(mesh.uvs[a]);
    areas.uv += std::abs(uv1.x * uv2.y - uv1.y * uv2.x) / 2;
  }
  return areas;
}

Areas areas_of(const description::Mesh& mesh, const Transform& world_from_object) {
  if (mesh.sphere) {
    const double radius = mesh.sphere->radius * similarity_scale(world_from_object);
    return {4 * pi_double * radius * radius, 1, 1};
  }
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  return areas_of(mesh, all, world_from_object);
}

bool has_equal_parts(const description::Mesh& mesh, std::size_t count,
                     const Transform& world_from_object) {
  if (count <= 1) return true;
  if (mesh.triangles.size() % count != 0) return false;
  std::vector<std::uint32_t> part(mesh.triangles.size() / count);
  std::iota(part.begin(), part.end(), 0u);
  double smallest = std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double area = areas_of(mesh, part, world_from_object).surface;
    smallest = std::min(smallest, area);
    largest = std::max(largest, area);
    for (std::uint32_t& triangle : part) triangle += static_cast<std::uint32_t>(part.size());
  }
  constexpr double rounding = 1e-3;  // of positions that are floats
  return largest - smallest <= rounding * largest;
}

double height_scale(const Areas& areas) {
  const double scale = areas.surface > 0 ? std::sqrt(areas.uv / areas.surface) : 0;
  return scale > 0 && std::isfinite(scale) ? scale : 1;
}

}  // namespace candela::pbrt
