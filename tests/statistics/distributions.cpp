#include "tests/statistics/distributions.h"

#include <cmath>
#include <initializer_list>
#include <limits>

namespace candela::statistics {
namespace {

constexpr double epsilon = 1e-15;
constexpr double tiny = 1e-300;
constexpr int max_terms = 1'000'000;

// x^a e^-x / Gamma(a), the factor that series and fraction share.
double gamma_factor(double a, double x) {
  return std::exp(a * std::log(x) - x - std::lgamma(a));
}

// P by its power series; converges fast for x < a + 1 [NR07, eq. 6.2.5].
double gamma_p_series(double a, double x) {
  double term = 1 / a;
  double sum = term;
  for (int n = 1; n < max_terms && std::abs(term) > std::abs(sum) * epsilon; ++n) {
    term *= x / (a + n);
    sum += term;
  }
  return sum * gamma_factor(a, x);
}

// Q by its continued fraction, evaluated by Lentz's method [NR07, eq. 6.2.7]; for x >= a + 1.
double gamma_q_fraction(double a, double x) {
  double b = x + 1 - a;
  double c = 1 / tiny;
  double d = 1 / b;
  double h = d;
  for (int i = 1; i < max_terms; ++i) {
    const double an = -i * (i - a);
    b += 2;
    d = an * d + b;
    if (std::abs(d) < tiny) d = tiny;
    c = b + an / c;
    if (std::abs(c) < tiny) c = tiny;
    d = 1 / d;
    const double change = d * c;
    h *= change;
    if (std::abs(change - 1) < epsilon) break;
  }
  return h * gamma_factor(a, x);
}

// The continued fraction of the incomplete beta function [NR07, eq. 6.4.5].
double beta_fraction(double a, double b, double x) {
  double c = 1;
  double d = 1 - (a + b) * x / (a + 1);
  d = 1 / (std::abs(d) < tiny ? tiny : d);
  double h = d;
  for (int m = 1; m < max_terms; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    double change = 1;
    for (const double coefficient : {even, odd}) {
      d = 1 + coefficient * d;
      d = 1 / (std::abs(d) < tiny ? tiny : d);
      c = 1 + coefficient / c;
      if (std::abs(c) < tiny) c = tiny;
      change = d * c;
      h *= change;
    }
    if (std::abs(change - 1) < epsilon) break;
  }
  return h;
}

// The root of an increasing function by bisection, after the bracket was doubled to hold it.
template <class F>
double invert_increasing(F cdf, double probability) {
  double low = -1;
  double high = 1;
  while (cdf(low) > probability && low > -1e300) low *= 2;
  while (cdf(high) < probability && high < 1e300) high *= 2;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (cdf(middle) < probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double gamma_p(double a, double x) {
  if (!(x > 0)) return 0;
  return x < a + 1 ? gamma_p_series(a, x) : 1 - gamma_q_fraction(a, x);
}

double gamma_q(double a, double x) {
  if (!(x > 0)) return 1;
  return x < a + 1 ? 1 - gamma_p_series(a, x) : gamma_q_fraction(a, x);
}

double incomplete_beta(double a, double b, double x) {
  if (!(x > 0)) return 0;
  if (!(x < 1)) return 1;
  const double factor = std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) +
                                 a * std::log(x) + b * std::log1p(-x));
  if (x < (a + 1) / (a + b + 2)) return factor * beta_fraction(a, b, x) / a;
  return 1 - factor * beta_fraction(b, a, 1 - x) / b;
}

double normal_cdf(double z) {
  return 0.5 * std::erfc(-z / std::sqrt(2.0));
}
double normal_survival(double z) {
  return normal_cdf(-z);
}
double normal_two_sided(double z) {
  return std::erfc(std::abs(z) / std::sqrt(2.0));
}
double normal_quantile(double probability) {
  if (probability > 0.5) return -normal_quantile(1 - probability);
  return invert_increasing(normal_cdf, probability);
}

double chi_square_cdf(double x, double degrees_of_freedom) {
  return gamma_p(degrees_of_freedom / 2, x / 2);
}
double chi_square_survival(double x, double degrees_of_freedom) {
  return gamma_q(degrees_of_freedom / 2, x / 2);
}

double t_two_sided(double t, double degrees_of_freedom) {
  if (std::isinf(degrees_of_freedom)) return normal_two_sided(t);
  if (std::isinf(t)) return 0;
  // [NR07, eq. 6.14.10]
  const double x = degrees_of_freedom / (degrees_of_freedom + t * t);
  return incomplete_beta(degrees_of_freedom / 2, 0.5, x);
}
double t_cdf(double t, double degrees_of_freedom) {
  const double tail = 0.5 * t_two_sided(t, degrees_of_freedom);
  return t > 0 ? 1 - tail : tail;
}
double t_quantile(double probability, double degrees_of_freedom) {
  if (probability > 0.5) return -t_quantile(1 - probability, degrees_of_freedom);
  return invert_increasing([=](double t) { return t_cdf(t, degrees_of_freedom); }, probability);
}

double kolmogorov_survival(double d, double n) {
  const double root = std::sqrt(n);
  const double x = d * (root + 0.12 + 0.11 / root);  // [NR07, eq. 14.3.18]
  if (x < 0.2) return 1;
  double sum = 0;
  for (int j = 1; j <= 100; ++j) {
    const double term = std::exp(-2.0 * j * j * x * x);
    sum += (j % 2 == 1 ? 2 : -2) * term;
    if (term < 1e-18) break;
  }
  return std::fmin(1.0, std::fmax(0.0, sum));
}

double sidak_level(double level, double count) {
  return -std::expm1(std::log1p(-level) / count);
}
double sidak_p_value(double smallest_p_value, double count) {
  if (smallest_p_value >= 1) return 1;
  return -std::expm1(count * std::log1p(-smallest_p_value));
}

}  // namespace candela::statistics
