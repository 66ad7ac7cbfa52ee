#include "renderer/scene/soup_parts.h"

#include <algorithm>
#include <vector>

namespace candela {
namespace {

bool is_soup(const description::Mesh& mesh) {
  if (mesh.positions.size() != 3 * mesh.triangles.size()) return false;
  std::uint32_t next = 0;
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const TriangleCorners& t) {
    next += 3;
    return t == TriangleCorners{next - 3, next - 2, next - 1};
  });
}

template <class T>
std::vector<T> part_of(const std::vector<T>& vertices, std::size_t first, std::size_t count) {
  if (vertices.empty()) return {};
  const auto begin = vertices.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

void share_corners(TriangleList& triangles, std::span<Geometry> others) {
  for (Geometry& other : others) {
    if (other.triangles.begins_with(triangles)) {
      triangles = other.triangles.prefix(triangles.size());
      return;
    }
    if (triangles.begins_with(other.triangles))
      other.triangles = triangles.prefix(other.triangles.size());
  }
}

}  // namespace

std::size_t part_count(const description::Mesh& mesh) {
  const std::size_t triangles = mesh.triangles.size();
  if (triangles <= triangles_of_a_part || mesh.materials.size() != 1 || !is_soup(mesh)) return 1;
  return (triangles + triangles_of_a_part - 1) / triangles_of_a_part;
}

description::Mesh part_of(const description::Mesh& mesh, std::size_t part) {
  const std::size_t first = part * triangles_of_a_part;
  const std::size_t count = std::min(triangles_of_a_part, mesh.triangles.size() - first);
  description::Mesh made;
  made.positions = part_of(mesh.positions, 3 * first, 3 * count);
  made.normals = part_of(mesh.normals, 3 * first, 3 * count);
  made.uvs = part_of(mesh.uvs, 3 * first, 3 * count);
  made.triangles = part_of(mesh.triangles, 0, count);
  made.materials = mesh.materials;
  return made;
}

void share_corners(std::span<Geometry> geometries, std::size_t first) {
  for (std::size_t i = first; i < geometries.size(); ++i)
    share_corners(geometries[i].triangles, geometries.first(i));
}

}  // namespace candela
