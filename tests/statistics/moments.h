// Mean and variance of a stream of numbers, and intervals for its mean.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "tests/statistics/distributions.h"

namespace candela::statistics {

struct Interval {
  double low = 0;
  double high = 0;
  [[nodiscard]] bool contains(double x) const { return low <= x && x <= high; }
};

// Welford's running moments: no cancellation, however far the mean is from 0.
class Moments {
 public:
  void add(double x) {
    ++count_;
    const double change = x - mean_;
    mean_ += change / static_cast<double>(count_);
    squares_ += change * (x - mean_);
  }

  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double mean() const { return mean_; }
  // Of the population, unbiased; infinite below two numbers.
  [[nodiscard]] double variance() const {
    if (count_ < 2) return std::numeric_limits<double>::infinity();
    return squares_ / static_cast<double>(count_ - 1);
  }
  [[nodiscard]] double variance_of_mean() const { return variance() / static_cast<double>(count_); }
  [[nodiscard]] double standard_error() const { return std::sqrt(variance_of_mean()); }

  // Holds the true mean with this probability (Student's t; exact for normal numbers).
  [[nodiscard]] Interval interval(double confidence) const {
    const double degrees = static_cast<double>(count_) - 1;
    const double reach = t_quantile(0.5 + 0.5 * confidence, degrees) * standard_error();
    return {mean_ - reach, mean_ + reach};
  }

  // The two-sided p-value of "the true mean is `expected`". Numbers without any spread must match
  // to the last few bits.
  [[nodiscard]] double p_value(double expected) const {
    const double difference = mean_ - expected;
    const double error = standard_error();
    if (!(error > 0)) return std::abs(difference) <= 1e-12 * std::abs(expected) ? 1 : 0;
    return t_two_sided(difference / error, static_cast<double>(count_) - 1);
  }

 private:
  std::uint64_t count_ = 0;
  double mean_ = 0;
  double squares_ = 0;
};

// The two-sided p-value of "both have the same mean" (Welch's test).
[[nodiscard]] inline double welch_p_value(const Moments& a, const Moments& b) {
  const double va = a.variance_of_mean();
  const double vb = b.variance_of_mean();
  if (!(va + vb > 0)) return a.mean() == b.mean() ? 1 : 0;
  const double degrees =
      (va + vb) * (va + vb) /
      (va * va / static_cast<double>(a.count() - 1) + vb * vb / static_cast<double>(b.count() - 1));
  return t_two_sided((a.mean() - b.mean()) / std::sqrt(va + vb), degrees);
}

}  // namespace candela::statistics
