// A ray in the compiled scene's space.
#pragma once

#include "renderer/math/constants.h"
#include "renderer/math/vec.h"

namespace candela {

// The sum of the absolute coordinates of a ray's origin and direction stays below (is_traceable()).
inline constexpr float farthest_traceable = 1e15f;

// Points origin + t * direction with 0 < t < t_max: t counts in lengths of the direction, which is
// unit for rays of the camera and of paths; shadow rays to a point end there at t = 1.
struct Ray {
  Vec3f origin{0};
  Vec3f direction{0, 0, 1};
  float t_max = infinity;
};

}  // namespace candela
