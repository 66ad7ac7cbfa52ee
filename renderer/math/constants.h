// Numbers that formulas name.
#pragma once

#include <limits>

namespace candela {

inline constexpr float pi = 3.14159265358979323846f;
inline constexpr float two_pi = 6.28318530717958647693f;
inline constexpr float inverse_pi = 0.31830988618379067154f;
inline constexpr double pi_double = 3.14159265358979323846;

inline constexpr float infinity = std::numeric_limits<float>::infinity();
// The largest float below 1: random numbers live in [0, one_minus_epsilon].
inline constexpr float one_minus_epsilon = 0x1.fffffep-1f;

// Bound of the relative error after n roundings: n eps / (1 - n eps) [Higham02, lemma 3.1].
constexpr float gamma_bound(int n) {
  const float half_ulp = std::numeric_limits<float>::epsilon() * 0.5f;
  const float n_eps = static_cast<float>(n) * half_ulp;
  return n_eps / (1 - n_eps);
}

}  // namespace candela
