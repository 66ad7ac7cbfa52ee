// Normals from files, whose length does not matter, as floats.
#pragma once

#include "renderer/math/vec.h"

namespace candela::mesh {

// Of another length where the square of its own would be no float.
[[nodiscard]] inline Vec3f to_float_direction(const Vec3d& normal) {
  constexpr double safe = 1e18;
  const double largest = max_component(glm::abs(normal));
  const bool is_moderate = largest == 0 || (largest > 1 / safe && largest < safe);
  return Vec3f(is_moderate ? normal : normal / largest);
}

}  // namespace candela::mesh
