#include "renderer/film/error_estimate.h"

#include <algorithm>
#include <cmath>

#include "renderer/film/heavy_tails.h"
#include "renderer/film/student_t.h"

namespace candela {
namespace {

// Of the pixels' errors.
struct ErrorSums {
  double sum = 0;
  double squares = 0;
};

ErrorSums sum_up(const std::vector<double>& errors) {
  ErrorSums all;
  for (const double error : errors) {
    all.sum += error;
    all.squares += error * error;
  }
  return all;
}

// What the true error of this picture is within, were the replicates' means normal: with R of them
// a pixel's estimate e of its variance v has Var(e) = 2 v^2 / (R - 1) and E(e^2) = v^2 (R + 1) /
// (R - 1), its squared error has the variance 2 v^2, and both are independent. Degrees of freedom
// after [Satterthwaite46]: R - 1 for each of the pixels that count. All of it is by pixels that are
// independent; where some are wrong together the sum's variance is up to that many times as large,
// with as many times fewer degrees. The levels that pixels are held
// against are off by some percent together, more seeds or pixels do not mend that: measured by
// tools/bench calibration.
Interval interval_of(const ErrorSums& errors, double pixels, double replicates, double together) {
  if (!(errors.squares > 0)) return {};
  const double variance = together * errors.squares * 2 * replicates / (replicates + 1);
  const double degrees = (replicates - 1) * errors.sum * errors.sum / (together * errors.squares);
  constexpr double common = 0.1;  // share of the sum that the levels may be off by
  const double reach = std::hypot(student_t_95(degrees) * std::sqrt(variance), common * errors.sum);
  return {std::max(errors.sum - reach, 0.0) / pixels, (errors.sum + reach) / pixels};
}

}  // namespace

StatedError stated_error(const ErrorEstimate& estimate) {
  return {estimate.rmse, std::sqrt(estimate.interval95.low), std::sqrt(estimate.interval95.high)};
}

ErrorEstimate estimate_error(const Film& film, const PixelErrors& errors, int together) {
  const ErrorSums sums = sum_up(errors.errors);
  const auto pixels = static_cast<double>(film.pixel_count());
  ErrorEstimate estimate;
  estimate.relmse = sums.sum / pixels;
  estimate.rmse = std::sqrt(estimate.relmse);
  estimate.interval95 =
      interval_of(sums, pixels, std::min(film.min_samples(), film.replicates()), together);
  const std::vector<bool> mask = heavy_tail_mask(film);
  estimate.heavy_tails = static_cast<double>(std::count(mask.begin(), mask.end(), true)) / pixels;
  return estimate;
}

std::optional<ErrorEstimate> estimate_error(const Film& film) {
  const std::optional<PixelErrors> errors = estimate_pixel_errors(film);
  if (!errors) return {};
  return estimate_error(film, *errors);
}

}  // namespace candela
