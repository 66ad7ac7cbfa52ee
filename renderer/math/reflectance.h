// Numbers that scene files give for surfaces, as BSDFs take them.
#pragma once

#include <algorithm>
#include <cmath>

#include "renderer/math/vec.h"

namespace candela {

// Of a surface of index eta + i k at normal incidence: ((eta-1)^2 + k^2) / ((eta+1)^2 + k^2), a
// channel.
template <class Colour>
[[nodiscard]] Colour normal_reflectance(const Colour& eta, const Colour& k) {
  const Colour one(1);
  return ((eta - one) * (eta - one) + k * k) / ((eta + one) * (eta + one) + k * k);
}

// Of metals given by their reflectance: above it k would be infinite.
inline constexpr double largest_metal_reflectance = 0.9999;

// k of a metal of eta = 1 by its reflectance at normal incidence, which is below 1.
template <class Real>
[[nodiscard]] Real extinction_of_reflectance(Real reflectance) {
  return 2 * std::sqrt(reflectance / (1 - reflectance));
}
template <class Real>
[[nodiscard]] glm::vec<3, Real> extinction_of_reflectance(const glm::vec<3, Real>& reflectance) {
  return {extinction_of_reflectance(reflectance.x), extinction_of_reflectance(reflectance.y),
          extinction_of_reflectance(reflectance.z)};
}

// The same of any eta; 0 where eta alone reflects more.
template <class Real>
[[nodiscard]] Real extinction_of_reflectance(Real eta, Real reflectance) {
  const Real k2 = (eta + 1) * (eta + 1) * reflectance - (eta - 1) * (eta - 1);
  return std::sqrt(std::max(k2, Real{0}) / (1 - reflectance));
}

// The GGX width with the highlight of Blinn-Phong's exponent [Walter07, section 5.2]; of those
// below 0 as of 0.
template <class Real>
[[nodiscard]] Real width_of_exponent(Real exponent) {
  return std::sqrt(2 / (std::max(Real{0}, exponent) + 2));
}

}  // namespace candela
