// Directions <-> points of a latitude-longitude map.
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

// The inverse, of length 1.
[[nodiscard]] inline Vec3f lat_long_direction(Vec2f st) {
  const SinCos polar = sin_cos(pi * st.y);
  const SinCos azimuth = sin_cos(two_pi * (st.x - 0.5f));
  return {polar.sin * azimuth.sin, polar.cos, -polar.sin * azimuth.cos};
}

}  // namespace candela
