// Metals by name: complex refractive indices eta + i k at 630, 532 and 465 nm.
#pragma once

#include <span>
#include <string_view>

#include "renderer/math/vec.h"

namespace candela::lab3 {

struct Metal {
  std::string_view name;
  Vec3d eta;
  Vec3d k;
};

// Names in lower case; "aluminum" is aluminium.
[[nodiscard]] std::span<const Metal> metals();

// `name` must be one of them.
[[nodiscard]] Metal metal_named(std::string_view name);

}  // namespace candela::lab3
