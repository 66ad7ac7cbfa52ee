// Where the segment between a surface and a light begins and ends.
#pragma once

#include "renderer/geometry/surface_point.h"

namespace candela {

// Just off the surface, on the side that `target` is on.
[[nodiscard]] inline Vec3f offset_towards(const SurfacePoint& from, const Vec3f& target) {
  return offset_origin(from.position, from.geometric_normal, from.offset, target - from.position);
}

// The last few ulps are left out, since the intersector's own t is rounded too.
[[nodiscard]] inline float short_of(float distance) {
  return distance * (1 - gamma_bound(16));
}

}  // namespace candela
