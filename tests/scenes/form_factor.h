// How much of what a small surface sees is a rectangle.
#pragma once

#include <cmath>

#include "renderer/math/constants.h"

namespace candela::test {

// From a differential element to a parallel rectangle a x b, a corner of which is at distance c
// above it: the closed form [Howell, B-3].
[[nodiscard]] inline double corner_form_factor(double a, double b, double c) {
  const double x = a / c, y = b / c;
  const double sx = std::sqrt(1 + x * x), sy = std::sqrt(1 + y * y);
  return (x / sx * std::atan(y / sx) + y / sy * std::atan(x / sy)) / (2 * pi_double);
}

}  // namespace candela::test
