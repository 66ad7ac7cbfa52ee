// What comes out again from between a dielectric coat and the metal below it: light followed from
// layer to layer, all directions of a cosine together.
#pragma once

#include <vector>

#include "renderer/bsdf/bsdf.h"

namespace candela {

// The layers as light meets them: widths as they are, 0 for smooth.
struct CoatedMetalLayers {
  float coat_alpha = 0;
  float metal_alpha = 0;
};

// Of light from each of the cosines, in (0, 1], the shares that leave the coat from below. `bsdf`:
// a coated conductor, of which index, thickness and count of bounces matter. Rows and columns of
// the layers' operators are cosines; azimuths do not matter to isotropic layers [Hulst80].
[[nodiscard]] std::vector<Vec3d> albedos_from_below(const Bsdf& bsdf,
                                                    const CoatedMetalLayers& layers,
                                                    const std::vector<double>& cosines);

}  // namespace candela
