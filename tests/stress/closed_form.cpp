#include "tests/stress/closed_form.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/statistics/moments.h"
#include "tests/stress/row.h"

namespace candela::test {
namespace {

using statistics::Moments;

double grey(const Image& image, int x, int y) {
  const float* const pixel = image.pixel(x, y);
  return (pixel[0] + double{pixel[1]} + double{pixel[2]}) / 3;
}

// The difference that is left when rounding is taken off, in standard errors of the renders, as a
// p-value.
double p_value(const Moments& found, double expected, double allowed_relative) {
  const double difference = std::abs(found.mean() - expected);
  const double excess = difference - allowed_relative * std::abs(expected);
  if (excess <= 0) return 1;
  if (!(found.standard_error() > 0)) return 0;
  return statistics::t_two_sided(excess / found.standard_error(),
                                 static_cast<double>(found.count()) - 1);
}

}  // namespace

void expect_mean(const Renders& renders, double expected, const ClosedForm& options) {
  Moments found;
  for (const Image& image : renders.images) found.add(mean_of(image));
  const double p = p_value(found, expected, options.allowed_relative);
  EXPECT_GT(p, options.level) << renders.name << ": " << found.mean() << " +- "
                              << found.standard_error() << ", expected " << expected;
  EXPECT_LE(found.standard_error(), options.resolution * std::abs(expected))
      << renders.name << ": the test sees too little";
  add_row(renders.name, {{"mean", found.mean()},
                         {"expected", expected},
                         {"standard error", found.standard_error()},
                         {"p", p},
                         {"invalid samples", static_cast<double>(renders.invalid_samples)}});
}

void expect_pixels(const Renders& renders, const std::function<double(int, int)>& expected,
                   const ClosedForm& options) {
  const Image& shape = renders.images[0];
  double least_p = 1, squared_error = 0, squared = 0;
  std::string worst;
  for (int y = 0; y < shape.height; ++y)
    for (int x = 0; x < shape.width; ++x) {
      Moments found;
      for (const Image& image : renders.images) found.add(grey(image, x, y));
      const double p = p_value(found, expected(x, y), options.allowed_relative);
      squared_error += found.variance_of_mean();
      squared += square(expected(x, y));
      if (p >= least_p) continue;
      least_p = p;
      worst = fmt::format("pixel ({}, {}) is {} +- {}, expected {}", x, y, found.mean(),
                          found.standard_error(), expected(x, y));
    }
  const auto count = static_cast<double>(shape.pixel_count());
  const double p = statistics::sidak_p_value(least_p, count);
  const double resolution = std::sqrt(squared_error / squared);
  EXPECT_GT(p, options.level) << renders.name << ": " << worst;
  EXPECT_LE(resolution, options.resolution) << renders.name << ": the test sees too little";
  add_row(renders.name, {{"p of the worst pixel", p},
                         {"relative standard error", resolution},
                         {"invalid samples", static_cast<double>(renders.invalid_samples)}});
}

}  // namespace candela::test
