#include "renderer/bsdf/energy_loss.h"

#include <cmath>

namespace candela {
namespace {

// root / c of Smith's Lambda = (root / c - 1) / 2 [Heitz14, eq. 72], in double: for narrow lobes
// what is lost is far below a float's rounding of what is kept.
double slope_ratio(double cosine, double a) {
  return std::sqrt(a * a + (1 - a * a) * cosine * cosine) / cosine;
}

// What of the light that the visible normal m mirrors is lost: 1 - G2 / G1(wo), all of it below the
// surface. [Dupuy23, listing 3] for the normal, u in (0, 1)^2.
double loss_of_sample(double cos_o, double a, double u1, double u2) {
  const double sin_o = std::sqrt((1 - cos_o) * (1 + cos_o));
  const Vec3d stretched = normalize(Vec3d(a * sin_o, 0, cos_o));
  const double phi = 2 * pi_double * u1;
  const double z = (1 - u2) * (1 + stretched.z) - stretched.z;
  const double r = std::sqrt(std::max(0.0, 1 - z * z));
  const Vec3d cap = stretched + Vec3d(r * std::cos(phi), r * std::sin(phi), z);
  const Vec3d m = normalize(Vec3d(a * cap.x, a * cap.y, cap.z));
  const double cos_i = 2 * (sin_o * m.x + cos_o * m.z) * m.z - cos_o;
  if (!(cos_i > 0)) return 1;
  const double ratio_i = slope_ratio(cos_i, a);
  return (ratio_i - 1) / (slope_ratio(cos_o, a) + ratio_i);
}

// The mean over visible normals; one half of them mirrors the other. Rings are shifted from turn to
// turn by the golden ratio: the edge below which nothing is lost would else lie along them.
double loss_by_quadrature(double cos_o, double a) {
  constexpr int turns = 24;
  constexpr int rings = 64;
  double sum = 0;
  for (int i = 0; i < turns; ++i) {
    const double shift = std::fmod(0.5 + i * 0.6180339887498949, 1.0);
    for (int j = 0; j < rings; ++j)
      sum += loss_of_sample(cos_o, a, (i + 0.5) / (2 * turns), (j + shift) / rings);
  }
  return sum / (turns * rings);
}

// 2 times the integral of loss(c) c dc by the midpoint rule over log(c): narrow lobes lose light
// about c = a.
double mean_by_quadrature(const EnergyLossTable& table, float a) {
  constexpr int steps = 1000;
  const double lowest = std::log(1e-4 * double{a});
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double c = std::exp(lowest * (i + 0.5) / steps);
    sum += 2 * c * c * double{table.loss(static_cast<float>(c), a)};
  }
  return sum * -lowest / steps;
}

}  // namespace

EnergyLossTable::EnergyLossTable() {
  for (std::size_t row = 0; row < nodes; ++row) {
    const double a = std::max(double{smallest_ggx_width}, static_cast<double>(row) / intervals);
    for (std::size_t column = 0; column < nodes; ++column) {
      const double x = std::max(1e-7, square(static_cast<double>(column) / intervals));
      losses_[row * nodes + column] =
          static_cast<float>(loss_by_quadrature(std::min(1.0, x * a / (1 + a - x)), a));
    }
  }
  // Of the table as it is interpolated, so that what it says is lost is what is put back.
  for (std::size_t i = 0; i <= mean_intervals; ++i) {
    const float root = static_cast<float>(i) / mean_intervals;
    const float a = std::max(smallest_ggx_width, root * root);
    means_over_a_[i] = static_cast<float>(mean_by_quadrature(*this, a) / double{a});
  }
}

const EnergyLossTable& energy_loss_table() {
  static const EnergyLossTable table;
  return table;
}

}  // namespace candela
