#include "scene_io/mesh/smooth_normals.h"

#include <algorithm>
#include <cmath>

namespace candela::mesh {
namespace {

// A factor that brings the mesh's edges near 1, so that products of tiny or huge ones stay normal.
double edge_scale(const std::vector<Vec3d>& positions) {
  Vec3d low = positions[0];
  Vec3d high = positions[0];
  for (const Vec3d& p : positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double half_extent = max_component(high * 0.5 - low * 0.5);
  return half_extent > 0.0 ? std::min(0.5 / half_extent, 1e300) : 1.0;
}

Vec3f unit_or_zero(const Vec3d& sum) {
  const double size = std::sqrt(length_squared(sum));
  return size > 0.0 ? Vec3f(sum / size) : Vec3f(0.0f);
}

}  // namespace

bool shares_vertices(const description::Mesh& mesh) {
  std::vector<bool> is_used(mesh.positions.size(), false);
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle) {
      if (is_used[vertex]) return true;
      is_used[vertex] = true;
    }
  return false;
}

void compute_smooth_normals(description::Mesh& mesh) {
  mesh.normals.clear();
  if (mesh.positions.empty()) return;
  const double scale = edge_scale(mesh.positions);
  std::vector<Vec3d> sums(mesh.positions.size(), Vec3d{0.0});
  for (const auto& [a, b, c] : mesh.triangles) {
    // Scaled before subtracting: the difference itself may be beyond the largest double.
    const Vec3d corner = mesh.positions[a] * scale;
    const Vec3d area_twice =
        cross(mesh.positions[b] * scale - corner, mesh.positions[c] * scale - corner);
    sums[a] += area_twice;
    sums[b] += area_twice;
    sums[c] += area_twice;
  }
  mesh.normals.resize(sums.size());
  std::transform(sums.begin(), sums.end(), mesh.normals.begin(), unit_or_zero);
}

}  // namespace candela::mesh
