// Mixtures: at each hit the surface is of one material, chosen by a random number. What emits and
// what covers is the mixture itself, so that light sampling and visibility need not know of them.
#pragma once

#include <vector>

#include "renderer/material/bsdf_at.h"

namespace candela {

// The part of a mixture, or of a mixture within it, that is met; u uniform in [0, 1). What is left
// of u after a choice is uniform again. A material that is no mixture is its own part.
[[nodiscard]] inline const Material& material_of_mix(const std::vector<Material>& materials,
                                                     const Material& mix,
                                                     const TextureStore& textures,
                                                     const TexturePoint& at, float u) {
  constexpr float below_one = 1 - 0x1p-24f;
  const Material* part = &mix;
  while (part->model == MaterialModel::Mix) {
    const float amount = scalar_at(part->amount, textures, at);
    const bool is_second = u < amount;
    u = std::min(is_second ? u / amount : (u - amount) / (1 - amount), below_one);
    part = &materials[part->parts[is_second ? 1 : 0].index];
  }
  return *part;
}

// For integrators without random numbers: the part that is there more often.
[[nodiscard]] inline const Material& greater_part_of_mix(const std::vector<Material>& materials,
                                                         const Material& mix,
                                                         const TextureStore& textures,
                                                         const TexturePoint& at) {
  const Material* part = &mix;
  while (part->model == MaterialModel::Mix)
    part = &materials[part->parts[scalar_at(part->amount, textures, at) > 0.5f ? 1 : 0].index];
  return *part;
}

}  // namespace candela
