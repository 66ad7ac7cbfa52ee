// Directions <-> points of a cube map.
//
// Faces count 0..5 as +X -X +Y -Y +Z -Z; (s, t) in [0, 1]^2 as in [OpenGL46, table 8.19], t from
// the file's first row.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "renderer/math/vec.h"

namespace candela {

struct CubePoint {
  std::uint32_t face = 0;
  Vec2f st{0.5f};
};

// Any direction but zero. Without branches, which directions would decide at random.
[[nodiscard]] inline CubePoint cube_point(const Vec3f& d) {
  Vec3f a = glm::abs(d);
  const bool is_x = a.x >= std::max(a.y, a.z);
  const bool is_y = a.y >= a.z;  // unless it is x
  const float along = is_x ? d.x : is_y ? d.y : d.z;
  const bool is_positive = along > 0;
  const float across = is_positive ? d.x : -d.x;
  const float turned = is_positive ? d.z : -d.z;
  const float s = is_x ? -turned : is_y ? d.x : across;
  const float t = is_x ? -d.y : is_y ? turned : -d.y;
  const std::uint32_t first_of_axis = is_x ? 0 : is_y ? 2 : 4;
  const float half = 0.5f / std::abs(along);
  return {first_of_axis + (is_positive ? 0u : 1u), {s * half + 0.5f, t * half + 0.5f}};
}

// The inverse; not of length 1.
[[nodiscard]] inline Vec3f cube_direction(const CubePoint& point) {
  const float s = 2 * point.st.x - 1;
  const float t = 2 * point.st.y - 1;
  const Vec3f faces[] = {{1, -t, -s}, {-1, -t, s}, {s, 1, t},
                         {s, -1, -t}, {s, -t, 1},  {-s, -t, -1}};
  return faces[point.face];
}

}  // namespace candela
