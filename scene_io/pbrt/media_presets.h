// Media by name: measured coefficients [Jensen01, figure 5].
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "renderer/math/vec.h"

namespace candela::pbrt {

// A millimetre. Scattering is the reduced one, which stands for isotropic scattering.
struct MediumPreset {
  std::string_view name;
  Vec3d scattering;
  Vec3d absorption;
};

[[nodiscard]] std::optional<MediumPreset> medium_preset(std::string_view name);
[[nodiscard]] std::vector<std::string_view> medium_preset_names();

}  // namespace candela::pbrt
