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

// Sums of what opposite faces bring, and how large they may be by rounding alone.
struct NormalSum {
  void add(const Vec3d& area_twice, double edges) {
    normal += area_twice;
    rounding += static_cast<float>(1e-14 * edges);
  }
  // Zero where nothing but rounding is left.
  [[nodiscard]] Vec3f unit_or_zero() const {
    const double size = std::sqrt(length_squared(normal));
    return size > static_cast<double>(rounding) ? Vec3f(normal / size) : Vec3f(0.0f);
  }

  Vec3d normal{0.0};
  float rounding = 0.0f;
};

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
  std::vector<NormalSum> sums(mesh.positions.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    // Scaled before subtracting: the difference itself may be beyond the largest double.
    const Vec3d corner = mesh.positions[a] * scale;
    const Vec3d first = mesh.positions[b] * scale - corner;
    const Vec3d second = mesh.positions[c] * scale - corner;
    const Vec3d area_twice = cross(first, second);
    const double edges = max_component(glm::abs(first)) * max_component(glm::abs(second));
    for (const std::uint32_t vertex : {a, b, c}) sums[vertex].add(area_twice, edges);
  }
  mesh.normals.resize(sums.size());
  std::transform(sums.begin(), sums.end(), mesh.normals.begin(),
                 [](const NormalSum& sum) { return sum.unit_or_zero(); });
}

}  // namespace candela::mesh
