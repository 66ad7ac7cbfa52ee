// Densities over the unit square that are bilinear between weights at its corners.
#pragma once

#include <cmath>

#include "renderer/math/constants.h"
#include "renderer/math/vec.h"

namespace candela {

// x in [0, 1) of density proportional to a (1 - x) + b x; a, b >= 0, and the larger from 1e-18 to
// 1e18, which is squared. The stable root of the quadratic [Hart20].
[[nodiscard]] inline float sample_linear(float u, float a, float b) {
  const float root = std::sqrt(a * a + u * (b * b - a * a));
  if (!(a + root > 0)) return 0;  // a is 0, and so is u
  return std::min(u * (a + b) / (a + root), one_minus_epsilon);
}

// Weights >= 0 at the corners (0,0), (1,0), (0,1), (1,1), not all of them 0.
struct BilinearDensity {
  float w00 = 1;
  float w10 = 1;
  float w01 = 1;
  float w11 = 1;

  [[nodiscard]] float at(Vec2f place) const {
    const float below = w00 + (w10 - w00) * place.x;
    const float above = w01 + (w11 - w01) * place.x;
    return 4 * (below + (above - below) * place.y) / (w00 + w10 + w01 + w11);
  }
  [[nodiscard]] Vec2f sample(Vec2f u) const {
    const float y = sample_linear(u.y, w00 + w10, w01 + w11);
    const float left = w00 + (w01 - w00) * y;
    const float right = w10 + (w11 - w10) * y;
    return {sample_linear(u.x, left, right), y};
  }
};

}  // namespace candela
