#include "renderer/scene/triangle_sort.h"

#include <limits>

#include "renderer/math/near_one.h"

namespace candela {
namespace {

// Squared in double, and so the same where denormal numbers are flushed. There surface points
// square this normal, and one of its components at least must be left.
bool has_area(const Vec3f& p0, const Vec3f& p1, const Vec3f& p2) {
  const double largest = max_component(glm::abs(cross(p1 - p0, p2 - p0)));
  return square(largest) >= std::numeric_limits<float>::min();
}

// Whether the file's own numbers say that the triangle is one, and no needle.
bool is_meant_to_be_seen(const description::Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
  constexpr double narrowest = 1e-3;
  const Vec3d a = near_one(mesh.positions[t[1]] - mesh.positions[t[0]]);
  const Vec3d b = near_one(mesh.positions[t[2]] - mesh.positions[t[0]]);
  const double sine2_times_lengths2 = length_squared(cross(a, b));
  return sine2_times_lengths2 > square(narrowest) * length_squared(a) * length_squared(b);
}

}  // namespace

Coverage coverage_of(const Scene& scene, const Material& material, const description::Mesh& mesh,
                     std::uint32_t triangle) {
  const ScalarParameter& opacity = material.opacity;
  if (!opacity.texture)
    return coverage_of_range(opacity.constant, opacity.constant, material.lab_opacity);
  Vec2f uv[3] = {Vec2f(0.5f), Vec2f(0.5f), Vec2f(0.5f)};
  if (!mesh.uvs.empty())
    for (std::size_t i = 0; i < 3; ++i) uv[i] = mesh.uvs[mesh.triangles[triangle][i]];
  const TextureStore::Range range =
      scene.textures.range_in_triangle(opacity.texture, uv, opacity.channel);
  return coverage_of_range(range.low, range.high, material.lab_opacity);
}

SortedTriangles sort_triangles(const Scene& scene, const Material& material,
                               const description::Mesh& mesh, const std::vector<Vec3f>& positions,
                               std::span<const std::uint32_t> triangles, bool decides_cutouts,
                               DropCounts& dropped) {
  SortedTriangles sorted;
  sorted.opaque.reserve(triangles.size());
  for (const std::uint32_t triangle : triangles) {
    const auto& index = mesh.triangles[triangle];
    const Vec3f& p0 = positions[index[0]];
    const Vec3f& p1 = positions[index[1]];
    const Vec3f& p2 = positions[index[2]];
    if (!is_in_reach(p0) || !is_in_reach(p1) || !is_in_reach(p2)) {
      ++dropped[DropReason::TrianglesOutOfReach];
      continue;
    }
    if (!has_area(p0, p1, p2)) {
      ++dropped[is_meant_to_be_seen(mesh, index) ? DropReason::TrianglesTooSmall
                                                 : DropReason::FlatTriangles];
      continue;
    }
    const Coverage coverage =
        decides_cutouts ? coverage_of(scene, material, mesh, triangle) : Coverage::Opaque;
    switch (coverage) {
      case Coverage::Opaque:
        sorted.opaque.push_back(triangle);
        break;
      case Coverage::Partial:
        sorted.partial.push_back(triangle);
        break;
      case Coverage::Clear:
        ++dropped[DropReason::ClearTriangles];
        break;
    }
  }
  return sorted;
}

}  // namespace candela
