// The report's formulas as they are printed, right or wrong: for the tests that show why candela
// has others (docs/report.md). Nothing but tests may include this.
#pragma once

#include <cmath>

#include "renderer/math/constants.h"
#include "renderer/math/vec.h"

namespace candela::printed {

// "theta = arccos(1 - xi1)" and "pdf = cos theta sin theta / pi" (REPORT 3.8).
[[nodiscard]] inline double cosine_theta(double xi1) {
  return std::acos(1 - xi1);
}
[[nodiscard]] inline double cosine_pdf(double theta) {
  return std::cos(theta) * std::sin(theta) / pi_double;
}

// "theta = arccos sqrt((1 - xi1) / (xi1 (alpha^2 - 1) + 1))" (REPORT 3.9).
[[nodiscard]] inline double ggx_theta(double xi1, double alpha) {
  return std::acos(std::sqrt((1 - xi1) / (xi1 * (alpha * alpha - 1) + 1)));
}
// "p_h = alpha^2 cos theta sin theta / (pi ((alpha^2 - 1) cos^2 theta + 1)^2)" (REPORT 3.9).
[[nodiscard]] inline double ggx_half_vector_pdf(double theta, double alpha) {
  const double a2 = alpha * alpha;
  const double cosine = std::cos(theta);
  return a2 * cosine * std::sin(theta) / (pi_double * square((a2 - 1) * cosine * cosine + 1));
}
// "pdf = p_h / (2 (wo.h))" (REPORT 3.9).
[[nodiscard]] inline double ggx_pdf(double theta, double alpha, double wo_dot_h) {
  return ggx_half_vector_pdf(theta, alpha) / (2 * wo_dot_h);
}

// "F(wi, N) = R0 + (1 - R0) (1 - wi.N)^5" (REPORT 2.3).
[[nodiscard]] inline double fresnel(double r0, double wi_dot_n) {
  return r0 + (1 - r0) * std::pow(1 - wi_dot_n, 5);
}

// "G1(w, h) = (w.h) / ((w.h) (1 - k) + k), k = (alpha + 1)^2 / 8" (REPORT 3.6).
[[nodiscard]] inline double g1(double w_dot_h, double alpha) {
  const double k = square(alpha + 1) / 8;
  return w_dot_h / (w_dot_h * (1 - k) + k);
}

// "D(h, N) = alpha^2 / (pi ((N.h)^2 (alpha^2 - 1) + 1)^2)", which is right (REPORT 3.7).
[[nodiscard]] inline double ggx_distribution(double n_dot_h, double alpha) {
  const double a2 = alpha * alpha;
  return a2 / (pi_double * square(n_dot_h * n_dot_h * (a2 - 1) + 1));
}

// "f_s = F G D / (4 (n.wi) (n.wo))", in the frame whose z is n.
[[nodiscard]] inline double specular(double f, double g, double d, double cos_i, double cos_o) {
  return f * g * d / (4 * cos_i * cos_o);
}

}  // namespace candela::printed
