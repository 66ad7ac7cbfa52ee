// How much light crosses the dielectric interface of a coat, and how much of what a Lambert surface
// below sends up comes back to it: what coated materials (coated_diffuse.h) need to be exact.
//
// The interface is smooth or GGX-rough with Smith's height-correlated masking, one bounce at a
// time; between it and the surface exp(-thickness / cosine) of the light is left after a crossing
// [Pharr23, section 14.3]. Energy throughout, without radiance's 1 / eta^2.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "renderer/bsdf/fresnel.h"
#include "renderer/bsdf/table_place.h"
#include "renderer/math/transcendental.h"

namespace candela {

class CoatTable {
 public:
  // For one width `alpha`, or, where it varies (`alpha` < 0), for all in [0, 1]. `eta`: of the coat
  // over the outside, at least 1.
  CoatTable(float eta, float thickness, float alpha);

  [[nodiscard]] float eta() const { return eta_; }
  [[nodiscard]] float thickness() const { return thickness_; }

  // The share of light from the cosine `cos_theta` outside that reaches the surface below.
  // `alpha` 0: the interface is smooth.
  [[nodiscard]] float transmittance(float cos_theta, float alpha) const {
    if (alpha == 0) return smooth_transmittance(cos_theta);
    const TablePlace column = table_place(std::sqrt(clamp_unit(cos_theta)), intervals);
    return interpolate(alpha, [&](const Row& row) {
      const float* at = &row.transmittances[column.index];
      return at[0] + (at[1] - at[0]) * column.fraction;
    });
  }
  // The cosine-weighted mean of transmittance().
  [[nodiscard]] float mean_transmittance(float alpha) const {
    return interpolate(alpha, [](const Row& row) { return row.mean_transmittance; });
  }
  // The share of uniform light from the surface that comes back to it.
  [[nodiscard]] float internal_reflectance(float alpha) const {
    return interpolate(alpha, [](const Row& row) { return row.internal_reflectance; });
  }

 private:
  static constexpr std::size_t intervals = 128;     // of the root of the cosine
  static constexpr std::size_t row_intervals = 16;  // of the fourth root of alpha

  struct Row {
    std::array<float, intervals + 1> transmittances{};
    float mean_transmittance = 0;
    float internal_reflectance = 0;
  };
  template <class Value>
  [[nodiscard]] float interpolate(float alpha, const Value& value) const {
    if (rows_.size() == 1) return value(rows_[0]);
    const TablePlace row = table_place(std::sqrt(std::sqrt(clamp_unit(alpha))), row_intervals);
    const float lower = value(rows_[row.index]);
    return lower + (value(rows_[row.index + 1]) - lower) * row.fraction;
  }
  [[nodiscard]] float smooth_transmittance(float cos_theta) const {
    const DielectricFresnel fresnel = fresnel_dielectric(cos_theta, eta_);
    if (!(fresnel.cos_transmitted > 0)) return 0;
    return (1 - fresnel.reflectance) * decay(thickness_ / fresnel.cos_transmitted);
  }
  [[nodiscard]] Row make_row(double alpha) const;

  float eta_;
  float thickness_;
  std::vector<Row> rows_;
};

}  // namespace candela
