// GGX microfacets of width a in double, for tables that integrate over them; 0: a flat surface.
// Directions lie in the plane of x and z and are told by their cosines with z.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>

#include "renderer/bsdf/fresnel.h"
#include "renderer/math/constants.h"
#include "renderer/math/vec.h"

namespace candela {

[[nodiscard]] inline double sine_of(double cosine) {
  return std::sqrt((1 - cosine) * (1 + cosine));
}

// Smith's Lambda [Heitz14, eq. 72].
[[nodiscard]] inline double smith_lambda(double cosine, double a) {
  const double tan2 = (1 - cosine) * (1 + cosine) / (cosine * cosine);
  return 0.5 * (std::sqrt(1 + a * a * tan2) - 1);
}

// 1 - G2 / G1(o) of a normal that o sees: what is masked of light that leaves at the cosine.
[[nodiscard]] inline double masked_share(double cos_o, double cosine, double a) {
  const double leaving = smith_lambda(std::min(1.0, cosine), a);
  return leaving / (1 + smith_lambda(cos_o, a) + leaving);
}

// A normal that o sees, by spherical caps [Dupuy23, listing 3], u in [0, 1)^2.
[[nodiscard]] inline Vec3d visible_normal(double cos_o, double a, double u1, double u2) {
  if (a == 0) return {0, 0, 1};
  const Vec3d stretched = normalize(Vec3d(a * sine_of(cos_o), 0, cos_o));
  const double z = (1 - u2) * (1 + stretched.z) - stretched.z;
  const double r = std::sqrt(std::max(0.0, 1 - z * z));
  const double phi = 2 * pi_double * u1;
  const Vec3d cap = stretched + Vec3d(r * std::cos(phi), r * std::sin(phi), z);
  return normalize(Vec3d(a * cap.x, a * cap.y, cap.z));
}

// The mean of value(m) over visible normals; one half of them mirrors the other. Rings are shifted
// from turn to turn by about the golden ratio: edges of what is integrated would else lie along
// them. `turns`: a Fibonacci number, by which all shifts are evenly spread.
template <int turns, int rings, class Value>
[[nodiscard]] double mean_over_visible_normals(double cos_o, double a, const Value& value) {
  constexpr int stride = static_cast<int>(0.6180339887498949 * turns + 0.5);
  static_assert(std::gcd(stride, turns) == 1);
  if (a == 0) return value(Vec3d(0, 0, 1));
  double sum = 0;
  for (int i = 0; i < turns; ++i) {
    const double shift = (i * stride % turns + 0.5) / turns;
    for (int j = 0; j < rings; ++j)
      sum += value(visible_normal(cos_o, a, (i + 0.5) / (2 * turns), (j + shift) / rings));
  }
  return sum / (turns * rings);
}

// The cosine of o mirrored by m; <= 0: not up again.
[[nodiscard]] inline double cosine_of_reflected(double cos_o, const Vec3d& m) {
  return 2 * (sine_of(cos_o) * m.x + cos_o * m.z) * m.z - cos_o;
}

// What a microfacet of an interface does to light from o.
struct InterfaceSplit {
  double reflectance = 1;
  double cos_reflected = 0;    // <= 0: not up again
  double cos_transmitted = 0;  // beyond; <= 0: not through
};

// `eta`: index of the far side over that of the side of o.
[[nodiscard]] inline InterfaceSplit split_at_microfacet(double cos_o, const Vec3d& m, double eta) {
  const double cos_m = sine_of(cos_o) * m.x + cos_o * m.z;
  if (cos_m <= 0) return {};
  const auto fresnel =
      fresnel_dielectric(static_cast<float>(std::min(1.0, cos_m)), static_cast<float>(eta));
  InterfaceSplit split{double{fresnel.reflectance}, cosine_of_reflected(cos_o, m), 0};
  const double cos_t2 = 1 - (1 - cos_m * cos_m) / (eta * eta);
  if (cos_t2 > 0) split.cos_transmitted = cos_o / eta - m.z * (cos_m / eta - std::sqrt(cos_t2));
  return split;
}

}  // namespace candela
