// Expectations over one uniform number, without noise: for estimators whose variance is infinite.
#pragma once

namespace candela::tests {

// The integral of f over (0, 1) by the midpoint rule in t = sqrt(x), which takes the edge off
// estimators that go like 1 / sqrt(x) at 0. Error about 1e-6 for what the report's tests integrate.
template <class F>
[[nodiscard]] double unit_integral(const F& f) {
  constexpr int steps = 20'000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) / steps;
    sum += f(t * t) * 2 * t;
  }
  return sum / steps;
}

}  // namespace candela::tests
