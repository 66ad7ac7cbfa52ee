#include "renderer/film/filter.h"

#include <cmath>
#include <vector>

#include "renderer/math/constants.h"

namespace candela {
namespace {

double gaussian(double x, double radius) {
  constexpr double sigma = 0.5;
  const auto bell = [](double d) { return std::exp(-d * d / (2 * sigma * sigma)); };
  return std::max(0.0, bell(x) - bell(radius));  // 0 at the edge, so nothing is cut
}

// The minimum four-term window [Harris78, table 1] over [-radius, radius].
double blackman_harris(double x, double radius) {
  const double phase = pi_double * (x / radius + 1);
  return std::max(0.0, 0.35875 - 0.48829 * std::cos(phase) + 0.14128 * std::cos(2 * phase) -
                           0.01168 * std::cos(3 * phase));
}

double value_at(FilterKind kind, double x, double radius) {
  switch (kind) {
    case FilterKind::Box:
      return 1;
    case FilterKind::Gaussian:
      return gaussian(x, radius);
    case FilterKind::BlackmanHarris:
      return blackman_harris(x, radius);
    case FilterKind::Triangle:
      return std::max(0.0, radius - std::abs(x));
  }
  return 0;
}

// Cumulative sums of the filter over `steps` equal cells of [-radius, radius], from 0 to 1.
std::vector<double> cumulative(FilterKind kind, double radius, int steps) {
  std::vector<double> sums(static_cast<std::size_t>(steps) + 1, 0.0);
  for (int i = 0; i < steps; ++i) {
    const double x = radius * ((2.0 * i + 1) / steps - 1);
    sums[static_cast<std::size_t>(i) + 1] =
        sums[static_cast<std::size_t>(i)] + value_at(kind, x, radius);
  }
  for (double& sum : sums) sum /= sums.back();
  return sums;
}

}  // namespace

float default_radius(FilterKind kind) {
  switch (kind) {
    case FilterKind::Box:
      return 0.5f;
    case FilterKind::Gaussian:
    case FilterKind::BlackmanHarris:
      return 1.5f;
    case FilterKind::Triangle:
      return 1;
  }
  return 1;
}

Filter::Filter(FilterKind kind, float radius) : kind_(kind), radius_(radius) {
  constexpr int steps = 1 << 14;
  const std::vector<double> sums = cumulative(kind, radius, steps);
  std::size_t cell = 0;
  for (int i = 0; i <= intervals; ++i) {
    const double u = static_cast<double>(i) / intervals;
    while (cell + 1 < steps && sums[cell + 1] < u) ++cell;
    const double within = (u - sums[cell]) / (sums[cell + 1] - sums[cell]);
    const double x = (static_cast<double>(cell) + std::clamp(within, 0.0, 1.0)) / steps;
    inverse_[static_cast<std::size_t>(i)] = static_cast<float>(radius * (2 * x - 1));
  }
  inverse_.front() = -radius;
  inverse_.back() = radius;
}

}  // namespace candela
