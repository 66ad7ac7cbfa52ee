#include "renderer/scene/pick_triangles.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/math/near_one.h"

namespace candela {
namespace {

std::vector<Vec3f> normalised_positions(const description::Mesh& mesh, const Transform& transform) {
  std::vector<Vec3f> positions;
  positions.reserve(mesh.positions.size() + 1);  // Embree reads past the last one
  positions.resize(mesh.positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
    positions[i] = Vec3f(transform.point(mesh.positions[i]));
  return positions;
}

// What it makes of normals is squares of lengths: the same map of a size near one.
Transform near_one(Transform transform) {
  Mat3d& m = transform.linear;
  const Vec3d largest(max_component(glm::abs(m[0])), max_component(glm::abs(m[1])),
                      max_component(glm::abs(m[2])));
  if (!is_finite(largest) || largest == Vec3d(0.0)) return transform;
  for (int i = 0; i < 3; ++i) m[i] = times_power_of_two(m[i], -exponent_of(largest));
  return transform;
}

// Unit length or zero, whatever the file has.
std::vector<Vec3f> normalised_normals(const description::Mesh& mesh, const Transform& placement) {
  const Transform transform = near_one(placement);
  std::vector<Vec3f> normals(mesh.normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Vec3d n = transform.normal(Vec3d(mesh.normals[i]));
    const double length2 = length_squared(n);
    const bool is_usable = length2 > 0 && std::isfinite(length2);
    normals[i] = is_usable ? Vec3f(n / std::sqrt(length2)) : Vec3f(0);
  }
  return normals;
}

// Whether the vertex normals say that the winding's normal points inwards.
bool is_wound_inwards(const Geometry& geometry, const TriangleCorners& t) {
  if (geometry.normals.empty()) return false;
  const Vec3f winding = cross(geometry.positions[t[1]] - geometry.positions[t[0]],
                              geometry.positions[t[2]] - geometry.positions[t[0]]);
  return dot(winding, geometry.normals[t[0]] + geometry.normals[t[1]] + geometry.normals[t[2]]) < 0;
}

// Appends vertex `v` of the mesh to the geometry once; `renumbered` remembers where.
std::uint32_t vertex_of(const MeshArrays& arrays, std::uint32_t v,
                        std::vector<std::uint32_t>& renumbered, Geometry& geometry) {
  constexpr std::uint32_t unseen = Handle<Geometry>::none;
  if (renumbered[v] != unseen) return renumbered[v];
  renumbered[v] = static_cast<std::uint32_t>(geometry.positions.size());
  geometry.positions.push_back(arrays.positions[v]);
  if (!arrays.normals.empty()) geometry.normals.push_back(arrays.normals[v]);
  if (!arrays.uvs.empty()) geometry.uvs.push_back(arrays.uvs[v]);
  return renumbered[v];
}

// Normals point to the side that windings call outside; where they disagree the normals are right.
void orient_windings(const Geometry& geometry, std::vector<TriangleCorners>& triangles) {
  for (TriangleCorners& t : triangles)
    if (is_wound_inwards(geometry, t)) std::swap(t[1], t[2]);
}

// Whether every vertex normal says what its triangles' windings say, to the digits that files have:
// then shading is flat, and the normals are not worth keeping.
bool are_normals_flat(const Geometry& geometry) {
  if (geometry.normals.empty()) return true;
  constexpr float six_digits = 2e-6f;
  return std::all_of(
      geometry.triangles.begin(), geometry.triangles.end(), [&](const TriangleCorners& t) {
        const Vec3d p0(geometry.positions[t[0]]);
        const Vec3d winding =
            cross(Vec3d(geometry.positions[t[1]]) - p0, Vec3d(geometry.positions[t[2]]) - p0);
        const Vec3f flat(winding / length(winding));
        return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
          const Vec3f& n = geometry.normals[v];
          return max_component(glm::abs(n - flat)) <= six_digits || n == Vec3f(0);
        });
      });
}

// Whether the triangles are all of the mesh and meet its vertices one after the other, and each.
bool take_all_in_order(const description::Mesh& mesh, std::span<const std::uint32_t> triangles) {
  if (triangles.size() != mesh.triangles.size()) return false;
  std::uint32_t next = 0;
  for (const std::uint32_t triangle : triangles)
    for (const std::uint32_t v : mesh.triangles[triangle]) {
      if (v > next) return false;
      if (v == next) ++next;
    }
  return next == mesh.positions.size();
}

// The triangles by vertices of the geometry, to which it adds just those that they use, in the
// order in which they use them; these are marked in `is_kept`. Takes the arrays as they are where
// that comes to the same: a copy would be the largest part of what compiling holds.
std::vector<TriangleCorners> pick(const description::Mesh& mesh, MeshArrays& arrays,
                                  std::span<const std::uint32_t> triangles,
                                  std::vector<bool>& is_kept, Geometry& geometry) {
  if (take_all_in_order(mesh, triangles)) {
    geometry.positions = std::move(arrays.positions);
    geometry.normals = std::move(arrays.normals);
    geometry.uvs = std::move(arrays.uvs);
    is_kept.assign(is_kept.size(), true);
    return mesh.triangles;
  }
  std::vector<TriangleCorners> chosen;
  chosen.reserve(triangles.size());
  const std::size_t most_vertices = std::min(arrays.positions.size(), 3 * triangles.size());
  geometry.positions.reserve(most_vertices + 1);  // Embree reads past the last one
  if (!arrays.normals.empty()) geometry.normals.reserve(most_vertices);
  if (!arrays.uvs.empty()) geometry.uvs.reserve(most_vertices);
  std::vector<std::uint32_t> renumbered(arrays.positions.size(), Handle<Geometry>::none);
  for (const std::uint32_t triangle : triangles) {
    TriangleCorners t{};
    for (std::size_t k = 0; k < 3; ++k)
      t[k] = vertex_of(arrays, mesh.triangles[triangle][k], renumbered, geometry);
    chosen.push_back(t);
  }
  for (std::size_t v = 0; v < renumbered.size(); ++v)
    if (renumbered[v] != Handle<Geometry>::none) is_kept[v] = true;
  return chosen;
}

}  // namespace

MeshArrays normalised_arrays(const description::Mesh& mesh, const Transform& to_normalised) {
  return {normalised_positions(mesh, to_normalised), normalised_normals(mesh, to_normalised), {}};
}

Geometry picked(const description::Mesh& mesh, MeshArrays& arrays,
                std::span<const std::uint32_t> triangles, std::uint32_t material, bool is_mirrored,
                std::vector<bool>& is_kept) {
  Geometry geometry;
  geometry.material = MaterialHandle(material);
  std::vector<TriangleCorners> chosen = pick(mesh, arrays, triangles, is_kept, geometry);
  if (is_mirrored)
    for (TriangleCorners& t : chosen) std::swap(t[1], t[2]);
  orient_windings(geometry, chosen);
  geometry.triangles = std::move(chosen);
  if (are_normals_flat(geometry)) std::vector<Vec3f>().swap(geometry.normals);
  return geometry;
}

}  // namespace candela
