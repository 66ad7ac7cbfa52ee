// White balance: the matrix by which a film shows light of one white as another's.
#pragma once

#include "renderer/math/vec.h"

namespace candela {

// x and y of CIE 1931.
struct Chromaticity {
  double x = 0;
  double y = 0;
};

// What temperatures of light may be.
inline constexpr double coolest_kelvins = 100;
inline constexpr double hottest_kelvins = 1e9;

// Of daylight of a correlated colour temperature [CIE15, section 4.1.2], which is meant by the
// second radiation constant of 1931: 6500 is D65's 6503.6 of today. Below 4000, where the CIE has
// no daylight, of a black body, as in pbrt. Kelvins beyond these limits count as the limit.
[[nodiscard]] Chromaticity daylight(double kelvins);

// Linear Rec.709 -> linear Rec.709: daylight of this temperature becomes neutral, of the luminance
// that it had. Von Kries' scaling of Bradford's cone responses [Lam85].
[[nodiscard]] Mat3d white_balance(double kelvins);

}  // namespace candela
