// Directions -> points of a latitude-longitude map.
//
// (s, t) in [0, 1]^2: t from the file's first row, which is +y; s = 1/2 looks along -z and grows
// towards +x.
#pragma once

#include "renderer/math/constants.h"
#include "renderer/math/transcendental.h"
#include "renderer/math/vec.h"

namespace candela {

// Of any direction whose square is a float and not 0.
[[nodiscard]] inline Vec2f lat_long_point(const Vec3f& d) {
  const float s = 0.5f + arc_tangent(d.x, -d.z) * (0.5f * inverse_pi);
  const float t = arc_tangent(std::sqrt(d.x * d.x + d.z * d.z), d.y) * inverse_pi;
  return {std::clamp(s, 0.0f, 1.0f), std::clamp(t, 0.0f, 1.0f)};
}

}  // namespace candela
