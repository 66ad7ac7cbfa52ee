// Vectors of any length, brought to where squares neither overflow nor underflow.
#pragma once

#include <cmath>

#include "renderer/math/vec.h"

namespace candela {

// The power of two of its largest component. `v` is finite and not zero.
[[nodiscard]] inline int exponent_of(const Vec3d& v) {
  int exponent = 0;
  (void)std::frexp(max_component(glm::abs(v)), &exponent);
  return exponent;
}

// v * 2^exponent: without rounding, where the result is no subnormal number.
[[nodiscard]] inline Vec3d times_power_of_two(const Vec3d& v, int exponent) {
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

// The same direction, the largest component of at least 1/2 and below 1.
[[nodiscard]] inline Vec3d near_one(const Vec3d& v) {
  return times_power_of_two(v, -exponent_of(v));
}

}  // namespace candela
