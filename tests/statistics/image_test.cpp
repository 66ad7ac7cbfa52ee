#include "tests/statistics/image_test.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tests/statistics/distributions.h"

namespace candela::statistics {
namespace {

// Sums over a region of one channel.
struct Difference {
  double first = 0;
  double second = 0;
  double variance = 0;
  int pixels = 0;

  void add(const Difference& other) {
    first += other.first;
    second += other.second;
    variance += other.variance;
    pixels += other.pixels;
  }
};

Difference pixel_difference(const NoisyImage& a, const NoisyImage& b, int x, int y, std::size_t c) {
  const auto variance = [&](const NoisyImage& image) {
    return image.variance_of_mean ? double{image.variance_of_mean->pixel(x, y)[c]} : 0.0;
  };
  return {a.mean->pixel(x, y)[c], b.mean->pixel(x, y)[c], variance(a) + variance(b), 1};
}

double z_score(const Difference& d, double relative_rounding) {
  const double difference = d.first - d.second;
  const double rounding = relative_rounding * std::max(std::abs(d.first), std::abs(d.second));
  if (std::abs(difference) <= rounding) return 0;
  if (!(d.variance > 0)) return std::copysign(std::numeric_limits<double>::infinity(), difference);
  return difference / std::sqrt(d.variance);
}

// The smallest p-value of a family of tests and their number.
struct Family {
  double smallest = 1;
  double count = 0;

  // True where this is the new smallest. NaN (of an invalid pixel) is the worst of all.
  bool add(double p_value) {
    ++count;
    const double p = std::isnan(p_value) ? 0 : p_value;
    if (p >= smallest && count > 1) return false;
    smallest = std::min(smallest, p);
    return true;
  }
  [[nodiscard]] double corrected() const { return sidak_p_value(smallest, std::max(1.0, count)); }
};

class Comparison {
 public:
  Comparison(const NoisyImage& a, const NoisyImage& b, const ImageTestOptions& options)
      : a_(a), b_(b), options_(options) {}

  ImageTestResult run() {
    for (std::size_t c = 0; c < a_.mean->channel_count(); ++c) test_channel(c);
    result_.pixel_p_value = pixels_.corrected();
    result_.block_p_value = blocks_.corrected();
    result_.whole_p_value = whole_.corrected();
    result_.whole_ratio = total_.first / total_.second;
    const double level = sidak_level(options_.level, 3);
    result_.passed = result_.pixel_p_value >= level && result_.block_p_value >= level &&
                     result_.whole_p_value >= level;
    result_.message = describe();
    return result_;
  }

 private:
  void test_channel(std::size_t c) {
    Difference whole;
    for (int y = 0; y < a_.mean->height; y += options_.block)
      for (int x = 0; x < a_.mean->width; x += options_.block) whole.add(test_block(x, y, c));
    whole_.add(p_value(whole));
    total_.add(whole);
  }

  Difference test_block(int x0, int y0, std::size_t c) {
    Difference block;
    for (int y = y0; y < std::min(y0 + options_.block, a_.mean->height); ++y)
      for (int x = x0; x < std::min(x0 + options_.block, a_.mean->width); ++x) {
        const Difference pixel = pixel_difference(a_, b_, x, y, c);
        test_pixel(pixel, x, y, c);
        block.add(pixel);
      }
    blocks_.add(p_value(block));
    return block;
  }

  void test_pixel(const Difference& pixel, int x, int y, std::size_t c) {
    if (!pixels_.add(p_value(pixel))) return;
    result_.worst_x = x;
    result_.worst_y = y;
    result_.worst_channel = static_cast<int>(c);
    result_.worst_z = z_score(pixel, options_.relative_rounding);
  }

  // A region's variance estimate has the degrees of freedom of its pixels together.
  [[nodiscard]] double p_value(const Difference& d) const {
    return t_two_sided(z_score(d, options_.relative_rounding),
                       options_.degrees_of_freedom * d.pixels);
  }

  [[nodiscard]] std::string describe() const {
    return fmt::format(
        "{}: p-values pixel {:.3g} block {:.3g} whole {:.3g} (each needs {:.3g}); worst pixel "
        "({}, {}) channel {} z {:.2f}; sum of the image / reference {:.5f}",
        result_.passed ? "images agree" : "images differ", result_.pixel_p_value,
        result_.block_p_value, result_.whole_p_value, sidak_level(options_.level, 3),
        result_.worst_x, result_.worst_y, result_.worst_channel, result_.worst_z,
        result_.whole_ratio);
  }

  const NoisyImage& a_;
  const NoisyImage& b_;
  const ImageTestOptions& options_;
  Family pixels_, blocks_, whole_;
  Difference total_;
  ImageTestResult result_;
};

bool same_shape(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height && a.channels == b.channels;
}

bool is_well_formed(const NoisyImage& image, const Image& shape) {
  return image.mean && same_shape(*image.mean, shape) &&
         (!image.variance_of_mean || (same_shape(*image.variance_of_mean, shape) &&
                                      std::ranges::none_of(image.variance_of_mean->values,
                                                           [](float v) { return !(v >= 0); })));
}

}  // namespace

ImageTestResult compare_images(const NoisyImage& image, const NoisyImage& reference,
                               const ImageTestOptions& options) {
  if (!image.mean || !is_well_formed(image, *image.mean) ||
      !is_well_formed(reference, *image.mean)) {
    ImageTestResult result;
    result.message = "the images differ in size or channels, or a variance is negative or NaN";
    return result;
  }
  return Comparison(image, reference, options).run();
}

}  // namespace candela::statistics
