// The ray between a surface and a point of a light.
#pragma once

#include "renderer/geometry/surface_point.h"

namespace candela {

inline constexpr float shadow_segment_end = 1 - gamma_bound(16);

// From just off the surface to `end`; `to_light` tells on which side. The last few ulps are left
// out, since the intersector's own t is rounded too.
[[nodiscard]] inline Ray shadow_segment(const SurfacePoint& from, const Vec3f& to_light,
                                        const Vec3f& end) {
  Vec3f origin = offset_origin(from.position, from.geometric_normal, from.offset, to_light);
  return {origin, end - origin, shadow_segment_end};
}

}  // namespace candela
