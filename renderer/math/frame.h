// Orthonormal frames: z is the normal; local directions have cos(theta) as their z.
#pragma once

#include "renderer/math/vec.h"

namespace candela {

struct Frame {
  Vec3f x{1, 0, 0};
  Vec3f y{0, 1, 0};
  Vec3f z{0, 0, 1};

  [[nodiscard]] Vec3f to_local(const Vec3f& v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
  [[nodiscard]] Vec3f to_world(const Vec3f& v) const { return x * v.x + y * v.y + z * v.z; }
};

// A frame about a unit normal, without branches or singularities [Duff17, listing 3].
[[nodiscard]] inline Frame frame_from_normal(const Vec3f& n) {
  const float sign = std::copysign(1.0f, n.z);
  const float a = -1.0f / (sign + n.z);
  const float b = n.x * n.y * a;
  return {{1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

// A frame about a unit normal whose x follows `tangent` as far as it can.
[[nodiscard]] inline Frame frame_from_normal_and_tangent(const Vec3f& n, const Vec3f& tangent) {
  Vec3f x = tangent - n * dot(n, tangent);
  const float length2 = dot(x, x);
  if (!(length2 > 1e-12f * dot(tangent, tangent))) return frame_from_normal(n);
  Vec3f unit_x = x / std::sqrt(length2);
  return {unit_x, cross(n, unit_x), n};
}

}  // namespace candela
