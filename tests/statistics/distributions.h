// The distributions that tests reason with, in double, from scratch.
//
// `_cdf` is P(X <= x), `_survival` P(X > x) computed without cancellation (so that a p-value of
// 1e-30 is right too), `_quantile` the inverse of `_cdf`. Relative error below 1e-10 or so for the
// arguments that tests meet (degrees of freedom up to 1e6).
#pragma once

namespace candela::statistics {

// The regularised incomplete gamma functions P(a, x) and Q = 1 - P; a > 0, x >= 0.
[[nodiscard]] double gamma_p(double a, double x);
[[nodiscard]] double gamma_q(double a, double x);

// The regularised incomplete beta function I_x(a, b); a, b > 0, x in [0, 1].
[[nodiscard]] double incomplete_beta(double a, double b, double x);

[[nodiscard]] double normal_cdf(double z);
[[nodiscard]] double normal_survival(double z);
[[nodiscard]] double normal_quantile(double probability);

// P(|Z| > |z|).
[[nodiscard]] double normal_two_sided(double z);

[[nodiscard]] double chi_square_cdf(double x, double degrees_of_freedom);
[[nodiscard]] double chi_square_survival(double x, double degrees_of_freedom);

// Student's t. An infinite number of degrees of freedom is the normal distribution.
[[nodiscard]] double t_cdf(double t, double degrees_of_freedom);
[[nodiscard]] double t_two_sided(double t, double degrees_of_freedom);
[[nodiscard]] double t_quantile(double probability, double degrees_of_freedom);

// P(sup |F_n - F| > d) for n samples of a continuous F, by the asymptotic series with Stephens'
// correction: good to about 1 % for n >= 40.
[[nodiscard]] double kolmogorov_survival(double d, double n);

// With `count` independent tests, the level for each at which all of them together have `level`
// [Sidak67]; and the p-value of the smallest of `count` p-values.
[[nodiscard]] double sidak_level(double level, double count);
[[nodiscard]] double sidak_p_value(double smallest_p_value, double count);

}  // namespace candela::statistics
