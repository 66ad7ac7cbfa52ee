// Directions of any length, from 1e-300 to 1e30 units.
#pragma once

#include "renderer/math/vec.h"

namespace candela::lab3 {

// Below this sine of an angle two directions count as one: the digits of a text tell no more.
inline constexpr double parallel_sine = 1e-12;

// `v` must not be zero. The squares of tiny components would underflow, so scale first.
[[nodiscard]] inline Vec3d unit(const Vec3d& v) {
  return normalize(v / max_component(glm::abs(v)));
}

[[nodiscard]] inline bool are_parallel(const Vec3d& a, const Vec3d& b) {
  return length(cross(unit(a), unit(b))) < parallel_sine;
}

}  // namespace candela::lab3
