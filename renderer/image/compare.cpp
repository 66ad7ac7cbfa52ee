#include "renderer/image/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "renderer/base/floating_point_traps.h"
#include "renderer/image/display_transform.h"
#include "renderer/image/relmse.h"

namespace candela {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double trimmed_share = 1e-3;
using Colour = std::array<double, 3>;

Colour colour_at(const Image& image, const ColourChannels& channels, std::size_t pixel) {
  const float* values = image.values.data() + pixel * image.channel_count();
  Colour colour{};
  for (std::size_t c = 0; c < 3; ++c) colour[c] = static_cast<double>(values[channels.rgb[c]]);
  return colour;
}

bool has_colour(const Image& image) {
  const bool has_all = image.channel_index("R") >= 0 && image.channel_index("G") >= 0 &&
                       image.channel_index("B") >= 0;
  return has_all || image.channel_count() == 1 || image.channel_index("Y") == 0;
}

Diagnostics check_comparable(const Image& image, const Image& reference) {
  if (image.width != reference.width || image.height != reference.height)
    return failure(
        fmt::format("the image has {} x {} pixels and the reference {} x {}: they must "
                    "be of one size",
                    image.width, image.height, reference.width, reference.height));
  if (image.pixel_count() == 0) return failure("the images have no pixels");
  if (!has_colour(image)) return failure("the image has no channels R, G and B");
  if (!has_colour(reference)) return failure("the reference has no channels R, G and B");
  return {};
}

// Of an image's values that are finite: `total` of those that are so in both images.
struct Sums {
  Colour total{};
  double all = 0;
  std::uint64_t count = 0;
  double largest = 0;
  std::uint64_t invalid = 0;

  void add(double value, std::size_t channel, bool is_other_finite) {
    if (!std::isfinite(value)) {
      ++invalid;
      return;
    }
    if (is_other_finite) total[channel] += value;
    all += value;
    ++count;
    largest = std::max(largest, value);
  }
};

// Of the image and the reference.
std::pair<Sums, Sums> sums_of(const Image& image, const Image& reference) {
  std::pair<Sums, Sums> sums;
  const ColourChannels channels = colour_channels(image);
  const ColourChannels reference_channels = colour_channels(reference);
  for (std::size_t i = 0; i < image.pixel_count(); ++i) {
    const Colour x = colour_at(image, channels, i);
    const Colour r = colour_at(reference, reference_channels, i);
    for (std::size_t c = 0; c < 3; ++c) {
      sums.first.add(x[c], c, std::isfinite(r[c]));
      sums.second.add(r[c], c, std::isfinite(x[c]));
    }
  }
  return sums;
}

double epsilon_of(const Sums& reference) {
  return relmse_epsilon(reference.count > 0 ? reference.all / static_cast<double>(reference.count)
                                            : 0.0);
}

struct PixelError {
  double relative = 0;
  double squared = 0;
};

// Black on black is no error even where the whole reference is black and epsilon is 0.
double relative_error(double x, double r, double epsilon) {
  const FloatingPointTraps traps(Traps::Off);  // it is infinite beside black
  const double difference = x - r;
  if (difference == 0) return 0;
  return difference * difference / (r * r + epsilon);
}

PixelError error_of(const Colour& x, const Colour& r, double epsilon) {
  PixelError error;
  for (std::size_t c = 0; c < 3; ++c) {
    if (!std::isfinite(x[c]) || !std::isfinite(r[c])) return {infinity, infinity};
    error.relative += relative_error(x[c], r[c], epsilon) / 3;
    error.squared += (x[c] - r[c]) * (x[c] - r[c]) / 3;
  }
  return error;
}

std::vector<PixelError> errors_of(const Image& image, const Image& reference, double epsilon) {
  const ColourChannels image_channels = colour_channels(image);
  const ColourChannels reference_channels = colour_channels(reference);
  std::vector<PixelError> errors(image.pixel_count());
  for (std::size_t i = 0; i < errors.size(); ++i)
    errors[i] = error_of(colour_at(image, image_channels, i),
                         colour_at(reference, reference_channels, i), epsilon);
  return errors;
}

double mean_of(const std::vector<double>& values, std::size_t count) {
  const auto end = values.begin() + static_cast<std::ptrdiff_t>(count);
  return std::accumulate(values.begin(), end, 0.0) / static_cast<double>(count);
}

// Sorts `errors` as far as it needs.
double trimmed_mean(std::vector<double>& errors) {
  const auto left_out =
      static_cast<std::size_t>(trimmed_share * static_cast<double>(errors.size()));
  const std::size_t kept = errors.size() - left_out;
  if (left_out > 0)
    std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(kept),
                     errors.end());
  return mean_of(errors, kept);
}

double ratio_of(double x, double r) {
  if (r != 0) return x / r;
  return x == 0 ? 1.0 : std::copysign(infinity, x);
}

double psnr_of(double largest, double mse) {
  const FloatingPointTraps traps(Traps::Off);  // errors may be infinite
  if (mse == 0) return infinity;
  return 10 * std::log10(largest * largest / mse);
}

void add_worst(ImageComparison& result, const Image& image, const Image& reference,
               const std::vector<PixelError>& errors) {
  const auto worst = std::ranges::max_element(errors, {}, &PixelError::relative);
  const auto index = static_cast<std::size_t>(worst - errors.begin());
  const auto width = static_cast<std::size_t>(image.width);
  result.worst_x = static_cast<int>(index % width);
  result.worst_y = static_cast<int>(index / width);
  result.worst_error = worst->relative;
  result.worst_image = colour_at(image, colour_channels(image), index);
  result.worst_reference = colour_at(reference, colour_channels(reference), index);
}

void add_errors(ImageComparison& result, const std::vector<PixelError>& errors,
                double largest_reference) {
  std::vector<double> relative(errors.size());
  std::ranges::transform(errors, relative.begin(), &PixelError::relative);
  double squared = 0;
  for (const PixelError& error : errors) squared += error.squared;
  result.relmse = mean_of(relative, relative.size());
  result.rmse = std::sqrt(result.relmse);
  result.relmse_trimmed = trimmed_mean(relative);
  result.mse = squared / static_cast<double>(errors.size());
  result.psnr = psnr_of(largest_reference, result.mse);
}

}  // namespace

Result<ImageComparison> compare_images(const Image& image, const Image& reference) {
  if (Diagnostics found = check_comparable(image, reference); found.has_errors()) return found;
  const auto [image_sums, reference_sums] = sums_of(image, reference);
  const std::vector<PixelError> errors = errors_of(image, reference, epsilon_of(reference_sums));
  ImageComparison result;
  result.width = image.width;
  result.height = image.height;
  result.invalid_in_image = image_sums.invalid;
  result.invalid_in_reference = reference_sums.invalid;
  result.invalid_values = image_sums.invalid + reference_sums.invalid;
  for (std::size_t c = 0; c < 3; ++c)
    result.mean_ratio[c] = ratio_of(image_sums.total[c], reference_sums.total[c]);
  add_errors(result, errors, reference_sums.largest);
  add_worst(result, image, reference, errors);
  return result;
}

Result<Image> error_heatmap(const Image& image, const Image& reference) {
  if (Diagnostics found = check_comparable(image, reference); found.has_errors()) return found;
  const std::vector<PixelError> errors =
      errors_of(image, reference, epsilon_of(sums_of(image, reference).second));
  constexpr std::array<float, 3> invalid{1, 0, 0};
  constexpr double lowest = -6, highest = 2;
  const FloatingPointTraps traps(Traps::Off);  // no error has the logarithm -infinity
  Image map(image.width, image.height, {"R", "G", "B"});
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double error = errors[i].relative;
    const double place = (std::log10(error) - lowest) / (highest - lowest);
    const auto colour = std::isfinite(error) ? heat_colour(place) : invalid;
    std::ranges::copy(colour, map.values.begin() + static_cast<std::ptrdiff_t>(3 * i));
  }
  return map;
}

}  // namespace candela
