// What both accelerators take in: triangles whose vertices are finite, instances that floats can
// invert. The rest can not be hit.
#pragma once

#include <optional>

#include "renderer/geometry/world_to_object.h"

namespace candela {

// Embree leaves out triangles with a vertex beyond this or not a number.
[[nodiscard]] inline bool is_usable_vertex(const Vec3f& p) {
  constexpr float limit = 1.844e18f;
  return std::isless(std::abs(p.x), limit) && std::isless(std::abs(p.y), limit) &&
         std::isless(std::abs(p.z), limit);
}

// The box of a triangle that can be hit.
[[nodiscard]] inline std::optional<Bounds3f> usable_box(const Geometry& geometry,
                                                        std::size_t triangle) {
  Bounds3f box;
  for (const std::uint32_t vertex : geometry.triangles[triangle]) {
    const Vec3f& p = geometry.positions[vertex];
    if (!is_usable_vertex(p)) return std::nullopt;
    box.include(p);
  }
  return box;
}

}  // namespace candela
