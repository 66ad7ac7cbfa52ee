// The energy that one bounce between GGX microfacets with Smith's height-correlated masking loses,
// since light that another microfacet blocks is dropped and not followed: 1 - E, with E(c, a) the
// albedo of reflectance 1 at the cosine c, for materials that put it back
// (compensated_cook_torrance.h).
#pragma once

#include <array>
#include <cstddef>

#include "renderer/bsdf/fresnel.h"
#include "renderer/bsdf/ggx.h"
#include "renderer/bsdf/table_place.h"

namespace candela {

// 1 - E over the root of x = c (1 + a) / (a + c) and the width a, both in [0, 1]: for small a the
// loss is a function of c / a, which x resolves at every a; the root resolves where it falls most
// steeply, at grazing angles. Bilinear between nodes; good to 1e-3.
class EnergyLossTable {
 public:
  EnergyLossTable();

  // 1 - E(c, a); a in [smallest_ggx_width, 1].
  [[nodiscard]] float loss(float cos_theta, float a) const {
    const float x = cos_theta * (1 + a) / (a + cos_theta);
    const TablePlace column = table_place(std::sqrt(clamp_unit(x)), intervals);
    const TablePlace row = table_place(a, intervals);
    const float* lower = &losses_[row.index * nodes + column.index];
    const float* upper = lower + nodes;
    const float at_lower = lower[0] + (lower[1] - lower[0]) * column.fraction;
    const float at_upper = upper[0] + (upper[1] - upper[0]) * column.fraction;
    return at_lower + (at_upper - at_lower) * row.fraction;
  }
  // The cosine-weighted mean over the hemisphere, 2 times the integral of loss(c, a) c dc.
  [[nodiscard]] float mean_loss(float a) const {
    const TablePlace place_of_a = table_place(std::sqrt(a), mean_intervals);
    const float* at = &means_over_a_[place_of_a.index];
    return a * (at[0] + (at[1] - at[0]) * place_of_a.fraction);
  }

 private:
  static constexpr std::size_t intervals = 40;
  static constexpr std::size_t nodes = intervals + 1;
  static constexpr std::size_t mean_intervals = 256;

  std::array<float, nodes * nodes> losses_{};             // [a][root of x]
  std::array<float, mean_intervals + 1> means_over_a_{};  // mean_loss / a over sqrt(a)
};

// Computed by the first call, once a process, in some hundredths of a second.
[[nodiscard]] const EnergyLossTable& energy_loss_table();

}  // namespace candela
