#include "renderer/scene/triangle_sort.h"

namespace candela {
namespace {

bool has_area(const Vec3f& p0, const Vec3f& p1, const Vec3f& p2) {
  const Vec3f n = cross(p1 - p0, p2 - p0);
  return dot(n, n) > 0;
}

// False for NaN and Inf, too.
bool is_in_reach(const Vec3f& p) {
  constexpr auto limit = static_cast<float>(out_of_reach_at);
  return std::abs(p.x) < limit && std::abs(p.y) < limit && std::abs(p.z) < limit;
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
      ++dropped[out_of_reach];
      continue;
    }
    if (!has_area(p0, p1, p2)) {
      ++dropped["triangles without area"];
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
        ++dropped["triangles that are wholly clear"];
        break;
    }
  }
  return sorted;
}

}  // namespace candela
