#include "scene_io/mesh/plane_grid.h"

#include <algorithm>
#include <cmath>

namespace candela::mesh {
namespace {

// Maps the box of the polygon into [0, 1]^3, one scale for all axes. Halves keep the extent of
// coordinates near the largest double finite.
struct UnitScale {
  Vec3d low{0.0};
  double per_extent = 0.0;  // 1 / (extent / 2)

  explicit UnitScale(std::span<const Vec3d> polygon) : low(polygon[0]) {
    Vec3d high = polygon[0];
    for (const Vec3d& p : polygon) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    const double half_extent = max_component(high * 0.5 - low * 0.5);
    per_extent = half_extent > 0.0 ? std::min(1.0 / half_extent, 1e300) : 0.0;
  }
  [[nodiscard]] Vec3d operator()(const Vec3d& p) const {
    return glm::clamp((p * 0.5 - low * 0.5) * per_extent, 0.0, 1.0);
  }
};

// Twice the area vector. [Sutherland74]
Vec3d newell_normal(std::span<const Vec3d> polygon, const UnitScale& scale) {
  Vec3d normal{0.0};
  const Vec3d first = scale(polygon[0]);
  Vec3d edge = scale(polygon[1]) - first;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vec3d next_edge = scale(polygon[i]) - first;
    normal += cross(edge, next_edge);
    edge = next_edge;
  }
  return normal;
}

std::int32_t snapped(double unit) {
  constexpr double steps = 1 << 30;
  return static_cast<std::int32_t>(std::lround(unit * steps));
}

}  // namespace

void project_to_grid(std::span<const Vec3d> polygon, std::vector<GridPoint>& points) {
  const UnitScale scale(polygon);
  const Vec3d normal = newell_normal(polygon, scale);
  const Vec3d size = glm::abs(normal);
  const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  int u = (axis + 1) % 3;
  int v = (axis + 2) % 3;
  if (normal[axis] < 0.0) std::swap(u, v);
  points.resize(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3d p = scale(polygon[i]);
    points[i] = {snapped(p[u]), snapped(p[v])};
  }
}

}  // namespace candela::mesh
