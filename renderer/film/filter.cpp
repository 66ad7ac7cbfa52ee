#include "renderer/film/filter.h"

#include <cmath>

#include "renderer/math/constants.h"

namespace candela {
namespace {

double gaussian(double x, double radius) {
  constexpr double sigma = 0.5;
  // Less the bell at the edge, so that nothing is cut; by a factor that tells small radii.
  const auto exponent = [](double d) { return -d * d / (2 * sigma * sigma); };
  const double edge = exponent(radius);
  return std::max(0.0, std::exp(edge) * std::expm1(exponent(x) - edge));
}

// The minimum four-term window [Harris78, table 1] over [-radius, radius].
double blackman_harris(double x, double radius) {
  const double phase = pi_double * (x / radius + 1);
  return std::max(0.0, 0.35875 - 0.48829 * std::cos(phase) + 0.14128 * std::cos(2 * phase) -
                           0.01168 * std::cos(3 * phase));
}

// B = C = 1/3 [Mitchell88, eq. 8], which reaches over two units.
double mitchell(double x, double radius) {
  const double t = 2 * std::abs(x) / radius;
  if (t < 1) return (7 * t * t * t - 12 * t * t + 16.0 / 3) / 6;
  return (-7.0 / 3 * t * t * t + 12 * t * t - 20 * t + 32.0 / 3) / 6;
}

double sinc(double x) {
  return std::abs(x) < 1e-5 ? 1 : std::sin(pi_double * x) / (pi_double * x);
}

// Three lobes of the window [Duchon79], whatever the radius.
double lanczos_sinc(double x) {
  constexpr double lobes = 3;
  return sinc(x) * sinc(x / lobes);
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
    case FilterKind::Mitchell:
      return mitchell(x, radius);
    case FilterKind::Sinc:
      return lanczos_sinc(x);
  }
  return 0;
}

// Cumulative sums of the filter's size over `steps` equal cells of [-radius, radius], from 0 to 1.
std::vector<double> cumulative(FilterKind kind, double radius, int steps) {
  std::vector<double> sums(static_cast<std::size_t>(steps) + 1, 0.0);
  for (int i = 0; i < steps; ++i) {
    const double x = radius * ((2.0 * i + 1) / steps - 1);
    sums[static_cast<std::size_t>(i) + 1] =
        sums[static_cast<std::size_t>(i)] + std::abs(value_at(kind, x, radius));
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
    case FilterKind::Mitchell:
      return 2;
    case FilterKind::Sinc:
      return 4;
  }
  return 1;
}

Filter::Filter(FilterKind kind, float radius) : kind_(kind), radius_(radius) {
  constexpr int steps = 1 << 14;
  const std::vector<double> sums = cumulative(kind, radius, steps);
  std::size_t cell = 0;
  for (int i = 1; i < parts; ++i) {
    const double u = number_at(i);
    while (cell + 1 < steps && sums[cell + 1] < u) ++cell;
    const double within = (u - sums[cell]) / (sums[cell + 1] - sums[cell]);
    const double x = (static_cast<double>(cell) + std::clamp(within, 0.0, 1.0)) / steps;
    inverse_[static_cast<std::size_t>(i)] = static_cast<float>(radius * (2 * x - 1));
  }
  inverse_.front() = -radius;
  inverse_.back() = 0;
  set_signs();
}

// Where the filter changes its sign, by bisection between places too near for two changes.
void Filter::set_signs() {
  constexpr int steps = 1 << 12;
  const auto is_negative = [&](double x) { return value_at(kind_, x, radius_) < 0; };
  const auto radius = static_cast<double>(radius_);
  for (int i = 0; i + 1 < steps; ++i) {
    double low = radius * (i + 0.5) / steps;
    double high = radius * (i + 1.5) / steps;
    if (is_negative(low) == is_negative(high)) continue;
    for (int halving = 0; halving < 40; ++halving) {
      const double middle = 0.5 * (low + high);
      (is_negative(middle) == is_negative(low) ? low : high) = middle;
    }
    sign_changes_.push_back(static_cast<float>(low));
  }
  double negative = 0;  // the share of the samples of one axis
  for (std::size_t i = 0; i < sign_changes_.size(); i += 2) {
    const double end = i + 1 < sign_changes_.size() ? double{sign_changes_[i + 1]} : radius;
    negative += 2 * (share_below(end) - share_below(double{sign_changes_[i]}));
  }
  size_over_sum_ = static_cast<float>(1 / (1 - 2 * negative));
}

// Of the samples of one axis, below x: what sample_axis() inverts.
double Filter::share_below(double x) const {
  if (x > 0) return 1 - share_below(-x);
  if (!(radius_ > 0)) return x < 0 ? 0 : 0.5;
  const auto above = std::upper_bound(inverse_.begin() + 1, inverse_.end() - 1, x);
  const double low = double{*(above - 1)};
  const double within = std::clamp((x - low) / (double{*above} - low), 0.0, 1.0);
  const auto part = static_cast<int>(above - inverse_.begin()) - 1;
  return number_at(part) + (number_at(part + 1) - number_at(part)) * within;
}

FilterPart Filter::part_within(const Bounds<Vec2d>& places) const {
  constexpr double rounding = 0x1p-22;  // of numbers, and of how places are interpolated
  FilterPart part{Vec2f(0), Vec2f(0)};
  for (int axis = 0; axis < 2; ++axis) {
    const double low = share_below(places.lower[axis]);
    const double high = share_below(places.upper[axis]);
    if (!(low < high)) return {Vec2f(0), Vec2f(0)};
    part.first[axis] = static_cast<float>(std::max(low - rounding, 0.0));
    part.size[axis] = static_cast<float>(std::min(high + rounding, 1.0)) - part.first[axis];
  }
  return part;
}

}  // namespace candela
