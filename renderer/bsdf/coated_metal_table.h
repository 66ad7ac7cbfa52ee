// What the metal's lobe of a coated conductor is multiplied by, colour by colour, so that what
// comes out of the coat from below is as much as light that is followed from layer to layer brings
// out.
#pragma once

#include <array>
#include <cstddef>

#include "renderer/bsdf/bsdf.h"
#include "renderer/bsdf/fresnel.h"
#include "renderer/bsdf/layered_metal.h"
#include "renderer/bsdf/table_place.h"

namespace candela {

class CoatedMetalTable {
 public:
  // `bsdf`: the coated conductor without a table, of one width a layer, not smooth.
  CoatedMetalTable(const Bsdf& bsdf, const CoatedMetalLayers& layers);

  // Of one direction; the lobe gets that of both.
  [[nodiscard]] Rgb scale(float cos_theta) const { return interpolate(scales_, cos_theta); }
  // What comes out from below of light from this direction.
  [[nodiscard]] Rgb albedo(float cos_theta) const { return interpolate(albedos_, cos_theta); }

 private:
  static constexpr std::size_t intervals = 32;  // of the root of the cosine
  using Row = std::array<Rgb, intervals + 1>;
  [[nodiscard]] static Rgb interpolate(const Row& row, float cos_theta) {
    const TablePlace at = table_place(std::sqrt(clamp_unit(cos_theta)), intervals);
    return row[at.index] + (row[at.index + 1] - row[at.index]) * at.fraction;
  }

  Row scales_{};
  Row albedos_{};
};

}  // namespace candela
