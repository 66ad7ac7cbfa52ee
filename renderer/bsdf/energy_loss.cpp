#include "renderer/bsdf/energy_loss.h"

#include <cmath>

#include "renderer/bsdf/table_microfacets.h"

namespace candela {
namespace {

// What of the light that visible normals mirror is lost, masked or below the surface.
double loss_by_quadrature(double cos_o, double a) {
  return mean_over_visible_normals<21, 72>(cos_o, a, [&](const Vec3d& m) {
    const double cos_i = cosine_of_reflected(cos_o, m);
    return cos_i > 0 ? masked_share(cos_o, cos_i, a) : 1.0;
  });
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
