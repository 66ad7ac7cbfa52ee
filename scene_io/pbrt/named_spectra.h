// The spectra that pbrt knows by name, as far as scenes use them.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "renderer/math/vec.h"

namespace candela::pbrt {

struct NamedMetal {
  std::string_view eta_name, k_name;
  Vec3d eta, k;
};
[[nodiscard]] std::span<const NamedMetal> named_metals();

struct NamedGlass {
  std::string_view name;
  double ior;  // at 587.6 nm
};
[[nodiscard]] std::span<const NamedGlass> named_glasses();

struct NamedIlluminant {
  std::string_view name;
  double x, y;  // chromaticity
};
[[nodiscard]] std::span<const NamedIlluminant> named_illuminants();

// All names, for suggestions.
[[nodiscard]] std::vector<std::string_view> spectrum_names();

}  // namespace candela::pbrt
