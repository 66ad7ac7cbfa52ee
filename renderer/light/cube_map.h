// Directions -> points of a cube map.
//
// Faces count 0..5 as +X -X +Y -Y +Z -Z; (s, t) in [0, 1]^2 as in [OpenGL46, table 8.19], t from
// the file's first row.
#pragma once

#include "renderer/math/vec.h"

namespace candela {

struct CubePoint {
  int face = 0;
  Vec2f st{0.5f};
};

// Any direction but zero.
[[nodiscard]] inline CubePoint cube_point(const Vec3f& d) {
  Vec3f a = glm::abs(d);
  const auto point = [](int face, float s, float t, float major) {
    const float half = 0.5f / major;
    return CubePoint{face, {s * half + 0.5f, t * half + 0.5f}};
  };
  if (a.x >= a.y && a.x >= a.z)
    return d.x > 0 ? point(0, -d.z, -d.y, a.x) : point(1, d.z, -d.y, a.x);
  if (a.y >= a.z) return d.y > 0 ? point(2, d.x, d.z, a.y) : point(3, d.x, -d.z, a.y);
  return d.z > 0 ? point(4, d.x, -d.y, a.z) : point(5, -d.x, -d.y, a.z);
}

}  // namespace candela
