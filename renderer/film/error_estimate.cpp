#include "renderer/film/error_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "renderer/base/parallel.h"
#include "renderer/film/heavy_tails.h"
#include "renderer/film/student_t.h"
#include "renderer/film/tiles.h"
#include "renderer/film/variance.h"

namespace candela {
namespace {

constexpr int widest = 8;  // radius of a window, pixels

// Sums over any rectangle of a block of pixels in constant time [Crow84].
class SummedArea {
 public:
  SummedArea(const Film& film, const PixelRect& rect)
      : rect_(rect), stride_(static_cast<std::size_t>(rect.width()) + 1),
        sums_(stride_ * (static_cast<std::size_t>(rect.height()) + 1)) {
    for (int y = rect.y0; y < rect.y1; ++y) {
      Moments row;
      for (int x = rect.x0; x < rect.x1; ++x) {
        const std::size_t i = film.index(x, y);
        row.mean += film.mean(i);
        row.variance += variance_of_mean(film, i);
        Moments& sum = at(x + 1, y + 1);
        sum.mean = at(x + 1, y).mean + row.mean;
        sum.variance = at(x + 1, y).variance + row.variance;
      }
    }
  }

  struct Moments {
    Vec3d mean{0.0};
    Vec3d variance{0.0};
  };
  [[nodiscard]] Moments sum(const PixelRect& r) const {
    const auto of = [&](auto member) {
      return at(r.x1, r.y1).*member - at(r.x0, r.y1).*member - at(r.x1, r.y0).*member +
             at(r.x0, r.y0).*member;
    };
    return {of(&Moments::mean), of(&Moments::variance)};
  }
  [[nodiscard]] PixelRect window(int x, int y, int radius) const {
    return {std::max(x - radius, rect_.x0), std::max(y - radius, rect_.y0),
            std::min(x + radius + 1, rect_.x1), std::min(y + radius + 1, rect_.y1)};
  }

 private:
  [[nodiscard]] std::size_t offset(int x, int y) const {
    return static_cast<std::size_t>(y - rect_.y0) * stride_ + static_cast<std::size_t>(x - rect_.x0);
  }
  [[nodiscard]] const Moments& at(int x, int y) const { return sums_[offset(x, y)]; }
  [[nodiscard]] Moments& at(int x, int y) { return sums_[offset(x, y)]; }

  PixelRect rect_;
  std::size_t stride_;
  std::vector<Moments> sums_;
};

// 1 / (r^2 + epsilon) of one channel from an estimate of r with a known variance. Plugging it in
// overstates where it is noisy; the second-order term of Taylor's series takes that away.
double inverse_square(double estimate, double variance, double epsilon) {
  const double square = estimate * estimate;
  const double sum = square + epsilon;
  const double curvature = (6 * square - 2 * epsilon) / (sum * sum);  // of the inverse, over it
  constexpr double most = 0.5;  // of the correction, where the series says nothing
  return (1 - std::clamp(0.5 * curvature * variance, -most, most)) / sum;
}

// The error of a pixel over what is there: the reference is estimated from the smallest window
// around it in which noise is small, so that it is not of the pixel's own noise where that is large.
class RelativeError {
 public:
  RelativeError(const Film& film, const PixelRect& rect, double epsilon)
      : film_(film), sums_(film, rect), epsilon_(epsilon) {}

  [[nodiscard]] double operator()(int x, int y) const {
    constexpr std::array radii{0, 1, 2, 3, 4, 6, widest};
    constexpr double small = 0.05;  // noise over level
    Level level;
    for (const int radius : radii) {
      level = level_in_window(x, y, radius);
      if (level.noise(epsilon_) <= small) break;
    }
    const Vec3d variance = variance_of_mean(film_, film_.index(x, y));
    double error = 0;
    for (int c = 0; c < 3; ++c)
      error += variance[c] * inverse_square(level.mean[c], level.variance[c], epsilon_);
    return error / 3;
  }

 private:
  struct Level {
    Vec3d mean{0.0};
    Vec3d variance{0.0};  // of `mean`
    [[nodiscard]] double noise(double epsilon) const {
      const Vec3d relative = variance / (mean * mean + epsilon);
      return (relative.x + relative.y + relative.z) / 3;
    }
  };

  [[nodiscard]] Level level_in_window(int x, int y, int radius) const {
    constexpr int steady = 2;  // a few pixels' variances together, since one's is a guess
    const PixelRect window = sums_.window(x, y, radius);
    const PixelRect wider = sums_.window(x, y, std::max(radius, steady));
    const auto count = [](const PixelRect& r) { return double(r.width()) * r.height(); };
    return {sums_.sum(window).mean / count(window),
            sums_.sum(wider).variance / (count(wider) * count(window))};
  }

  const Film& film_;
  SummedArea sums_;
  double epsilon_;
};

PixelRect widened(const PixelRect& rect, int by, const PixelRect& within) {
  return {std::max(rect.x0 - by, within.x0), std::max(rect.y0 - by, within.y0),
          std::min(rect.x1 + by, within.x1), std::min(rect.y1 + by, within.y1)};
}

double mean_radiance(const Film& film) {
  double sum = 0;
  for (std::size_t i = 0; i < film.pixel_count(); ++i) {
    const Vec3d mean = film.mean(i);
    sum += mean.x + mean.y + mean.z;
  }
  return sum / (3.0 * static_cast<double>(film.pixel_count()));
}

// Of the pixels' errors.
struct ErrorSums {
  double sum = 0;
  double squares = 0;
};

ErrorSums sum_errors(const Film& film) {
  const double mean = mean_radiance(film);
  const double epsilon = 1e-2 * mean * mean;  // compare.h
  if (!(epsilon > 0)) return {};  // a black picture
  constexpr int block_size = 64;
  const std::vector<PixelRect> blocks = tiles_of(film.crop(), block_size);
  std::vector<ErrorSums> parts(blocks.size());
  parallel_for(blocks.size(), [&](std::size_t b) {
    const RelativeError error(film, widened(blocks[b], widest, film.crop()), epsilon);
    for (int y = blocks[b].y0; y < blocks[b].y1; ++y)
      for (int x = blocks[b].x0; x < blocks[b].x1; ++x) {
        const double value = error(x, y);
        parts[b].sum += value;
        parts[b].squares += value * value;
      }
  });
  ErrorSums all;
  for (const ErrorSums& part : parts) {
    all.sum += part.sum;
    all.squares += part.squares;
  }
  return all;
}

// What the true error of this picture is within, were the replicates' means normal: with R of them
// a pixel's estimate e of its variance v has Var(e) = 2 v^2 / (R - 1) and E(e^2) = v^2 (R + 1) /
// (R - 1), its squared error has the variance 2 v^2, and both are independent. Degrees of freedom
// after [Satterthwaite46]: R - 1 for each of the pixels that count.
Interval interval_of(const ErrorSums& errors, double pixels, double replicates) {
  if (!(errors.squares > 0)) return {};
  const double variance = errors.squares * 2 * replicates / (replicates + 1);
  const double degrees = (replicates - 1) * errors.sum * errors.sum / errors.squares;
  const double reach = student_t_95(degrees) * std::sqrt(variance);
  return {std::max(errors.sum - reach, 0.0) / pixels, (errors.sum + reach) / pixels};
}

}  // namespace

std::optional<ErrorEstimate> estimate_error(const Film& film) {
  const std::uint32_t replicates = std::min(film.min_samples(), film.replicates());
  if (replicates < 2) return {};
  const ErrorSums errors = sum_errors(film);
  const auto pixels = static_cast<double>(film.pixel_count());
  ErrorEstimate estimate;
  estimate.relmse = errors.sum / pixels;
  estimate.rmse = std::sqrt(estimate.relmse);
  estimate.interval95 = interval_of(errors, pixels, replicates);
  const std::vector<bool> mask = heavy_tail_mask(film);
  estimate.heavy_tails = static_cast<double>(std::count(mask.begin(), mask.end(), true)) / pixels;
  return estimate;
}

}  // namespace candela
