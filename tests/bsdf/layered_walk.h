// Light between a dielectric interface and a surface below it, followed bounce by bounce in double:
// what coated materials are held against. Interfaces are smooth or GGX with Smith's
// height-correlated masking, scatter once a meeting, and lose what they block; between them
// exp(-thickness / cosine) is left after a crossing.
#pragma once

#include <complex>
#include <cstdint>
#include <optional>

#include "renderer/math/vec.h"

namespace candela::tests {

struct LayeredSurface {
  double eta = 1.5;  // of the coat
  double coat_alpha = 0;
  double thickness = 0.01;
  int bounces = 0;                                 // off the surface below, at most; 0: no limit
  std::optional<std::complex<double>> metal = {};  // index of the surface against vacuum
  double metal_alpha = 0;
  double reflectance = 0.5;  // else Lambert's
};

// What becomes of one unit of light from the cosine `cos_o`.
struct WalkEnd {
  double coat = 0;   // what the coat reflected
  double below = 0;  // what came out from below
};
[[nodiscard]] WalkEnd walk_layers(const LayeredSurface& surface, double cos_o, std::uint64_t seed);

}  // namespace candela::tests
