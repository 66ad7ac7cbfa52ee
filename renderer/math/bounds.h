// Axis-aligned boxes.
#pragma once

#include <limits>

#include "renderer/math/vec.h"

namespace candela {

// Empty until something is included: lower > upper.
template <class V>
struct Bounds {
  using Number = typename V::value_type;
  V lower{std::numeric_limits<Number>::infinity()};
  V upper{-std::numeric_limits<Number>::infinity()};

  [[nodiscard]] bool is_empty() const { return !(lower.x <= upper.x); }
  void include(const V& p) {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  void include(const Bounds& other) {
    lower = glm::min(lower, other.lower);
    upper = glm::max(upper, other.upper);
  }
  // One of the eight, by its bits: 1 for the upper x, 2 for y, 4 for z.
  [[nodiscard]] V corner(int bits) const {
    return {(bits & 1) != 0 ? upper.x : lower.x, (bits & 2) != 0 ? upper.y : lower.y,
            (bits & 4) != 0 ? upper.z : lower.z};
  }
  [[nodiscard]] V centre() const { return lower * Number(0.5) + upper * Number(0.5); }
  [[nodiscard]] V extent() const { return upper - lower; }
  // 0 for an empty box.
  [[nodiscard]] Number surface_area() const {
    if (is_empty()) return 0;
    const V e = extent();
    return 2 * (e.x * e.y + e.y * e.z + e.z * e.x);
  }
};

using Bounds3f = Bounds<Vec3f>;
using Bounds3d = Bounds<Vec3d>;

}  // namespace candela
