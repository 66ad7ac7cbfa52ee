#include "renderer/film/pixel_planes.h"

#include <cmath>

#include "renderer/base/vector_widths.h"

namespace candela {
namespace {

// sums[i] = a[i] + b[i].
CANDELA_LANES void add(std::size_t count, const double* a, const double* b,
                       double* __restrict sums) {
  for (std::size_t i = 0; i < count; ++i) sums[i] = a[i] + b[i];
}

CANDELA_LANES void multiply(std::size_t count, const double* a, const double* b,
                            double* __restrict products) {
  for (std::size_t i = 0; i < count; ++i) products[i] = a[i] * b[i];
}

CANDELA_LANES void square_mean_root(std::size_t count, const double* x, const double* y,
                                    const double* z, double* __restrict squares) {
  for (std::size_t i = 0; i < count; ++i) {
    const double mean = (std::sqrt(x[i]) + std::sqrt(y[i]) + std::sqrt(z[i])) / 3;
    squares[i] = mean * mean;
  }
}

CANDELA_LANES void divide_by_nine(std::size_t count, double* numbers) {
  for (std::size_t i = 0; i < count; ++i) numbers[i] /= 9;
}

// Of each and the one `step` places on.
Plane sum_of_two(const Plane& plane, std::size_t step) {
  Plane sums(plane.size());
  if (plane.size() > step) add(plane.size() - step, plane.data(), plane.data() + step, sums.data());
  return sums;
}

// Of each and the three that follow at a distance of `step`.
Plane sum_of_four(const Plane& plane, std::size_t step) {
  return sum_of_two(sum_of_two(plane, step), 2 * step);
}

// Of the four before and the four after each.
Plane sum_beside(const Plane& plane, std::size_t step) {
  const Plane fours = sum_of_four(plane, step);
  Plane sums(plane.size());
  if (plane.size() > 8 * step)
    add(plane.size() - 8 * step, fours.data(), fours.data() + 5 * step, sums.data() + 4 * step);
  return sums;
}

// Of the one before, the one in the middle and the one after.
Plane sum_of_three(const Plane& plane, std::size_t step) {
  Plane sums(plane.size());
  if (plane.size() <= 2 * step) return sums;
  const std::size_t count = plane.size() - 2 * step;
  const Plane twos = sum_of_two(plane, step);
  add(count, twos.data(), plane.data() + 2 * step, sums.data() + step);
  return sums;
}

Plane sum(const Plane& a, const Plane& b) {
  Plane sums(a.size());
  add(a.size(), a.data(), b.data(), sums.data());
  return sums;
}

}  // namespace

Plane mean_of_nine(const Plane& plane, std::size_t width) {
  Plane means = sum_of_three(sum_of_three(plane, 1), width);
  divide_by_nine(means.size(), means.data());
  return means;
}

Plane sum_near_by(const Plane& plane, std::size_t width) {
  const Plane beside = sum_beside(plane, 1);
  return sum(sum_beside(sum(beside, plane), width), beside);
}

Plane variance_in_phase(const Planes& variances) {
  Plane of_grey(variances[0].size());
  square_mean_root(of_grey.size(), variances[0].data(), variances[1].data(), variances[2].data(),
                   of_grey.data());
  return of_grey;
}

Plane product(const Plane& a, const Plane& b) {
  Plane products(a.size());
  multiply(a.size(), a.data(), b.data(), products.data());
  return products;
}

}  // namespace candela
