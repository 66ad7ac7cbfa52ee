// Student's t distribution, as far as intervals need it.
#pragma once

#include <algorithm>
#include <cmath>

#include "renderer/math/constants.h"

namespace candela {

// The t that |T| stays below with a probability of 95 %; `degrees` of freedom, at least 1, need not
// be whole. [Hill70, algorithm 396]: within 2e-5 from 3 on, .2 % from 2; below, between the exact
// values of 1 and 2, within 3 % (tested).
[[nodiscard]] inline double student_t_95(double degrees) {
  constexpr double outside = 0.05;
  constexpr double normal = -1.959963984540054;  // the normal distribution's 2.5 % point
  const double n = std::max(degrees, 1.0);
  if (n < 2) {
    constexpr double of_one = 12.706204736432095;
    constexpr double of_two = 4.302652729911275;
    return of_one * std::pow(of_two / of_one, 2 - 2 / n);
  }
  const double a = 1 / (n - 0.5);
  const double b = 48 / (a * a);
  double c = ((20700 * a / b - 98) * a - 16) * a + 96.36;
  const double d = ((94.5 / (b + c) - 3) / b + 1) * std::sqrt(a * pi_double / 2) * n;
  double y = std::pow(d * outside, 2 / n);
  if (y <= 0.05 + a) {
    y = ((1 / (((n + 6) / (n * y) - 0.089 * d - 0.822) * (n + 2) * 3) + 0.5 / (n + 4)) * y - 1) *
            (n + 1) / (n + 2) +
        1 / y;
    return std::sqrt(n * y);
  }
  const double x = normal;
  y = x * x;
  if (n < 5) c += 0.3 * (n - 4.5) * (x + 0.6);
  c += (((0.05 * d * x - 5) * x - 7) * x - 2) * x + b;
  y = (((((0.4 * y + 6.3) * y + 36) * y + 94.5) / c - y - 3) / b + 1) * x;
  return std::sqrt(n * std::expm1(a * y * y));
}

}  // namespace candela
