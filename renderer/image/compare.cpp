#include "renderer/image/compare.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>

#include <fmt/format.h>

namespace candela {
namespace {

using ColourChannels = std::array<std::size_t, 3>;

std::optional<ColourChannels> colour_channels(const Image& image) {
  if (image.channel_count() == 1) return ColourChannels{0, 0, 0};
  ColourChannels found{};
  constexpr std::array<const char*, 3> names{"R", "G", "B"};
  for (std::size_t c = 0; c < 3; ++c) {
    const int index = image.channel_index(names[c]);
    if (index < 0) return std::nullopt;
    found[c] = static_cast<std::size_t>(index);
  }
  return found;
}

// Both images' colours side by side, in double.
struct Pair {
  std::size_t pixels = 0;
  std::vector<std::array<double, 3>> x;
  std::vector<std::array<double, 3>> r;
  double epsilon = 0;
};

std::vector<std::array<double, 3>> colours_of(const Image& image, const ColourChannels& channels) {
  std::vector<std::array<double, 3>> colours(image.pixel_count());
  for (std::size_t i = 0; i < colours.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      colours[i][c] = static_cast<double>(image.values[i * image.channel_count() + channels[c]]);
  return colours;
}

double mean_of(const std::vector<std::array<double, 3>>& colours, std::size_t channel) {
  double sum = 0;
  for (const auto& colour : colours) sum += colour[channel];
  return sum / static_cast<double>(colours.size());
}

Result<Pair> paired(const Image& image, const Image& reference) {
  if (image.width != reference.width || image.height != reference.height)
    return failure(
        fmt::format("the image has {} x {} pixels and the reference {} x {}: they must "
                    "be of one size",
                    image.width, image.height, reference.width, reference.height));
  if (image.pixel_count() == 0) return failure("the images have no pixels");
  const auto image_channels = colour_channels(image);
  const auto reference_channels = colour_channels(reference);
  if (!image_channels || !reference_channels)
    return failure(
        fmt::format("the {} has no channels R, G and B", image_channels ? "reference" : "image"));
  Pair pair{image.pixel_count(), colours_of(image, *image_channels),
            colours_of(reference, *reference_channels), 0};
  const double mean = (mean_of(pair.r, 0) + mean_of(pair.r, 1) + mean_of(pair.r, 2)) / 3;
  pair.epsilon = 1e-2 * mean * mean;
  return pair;
}

// (x - r)^2 / (r^2 + eps), averaged over a pixel's channels. A black reference has eps 0: what is
// black as well has no error then.
double pixel_error(const Pair& pair, std::size_t i) {
  double sum = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double difference = pair.x[i][c] - pair.r[i][c];
    if (difference == 0) continue;
    sum += difference * difference / (pair.r[i][c] * pair.r[i][c] + pair.epsilon);
  }
  return sum / 3;
}

std::uint64_t count_invalid(const Pair& pair) {
  std::uint64_t count = 0;
  for (const auto* colours : {&pair.x, &pair.r})
    for (const auto& colour : *colours)
      for (const double v : colour) count += std::isfinite(v) ? 0 : 1;
  return count;
}

double psnr_of(const Pair& pair) {
  double squares = 0;
  double peak = 0;
  for (std::size_t i = 0; i < pair.pixels; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      squares += std::pow(pair.x[i][c] - pair.r[i][c], 2);
      peak = std::max(peak, std::abs(pair.r[i][c]));
    }
  const double mse = squares / static_cast<double>(3 * pair.pixels);
  return mse == 0 ? std::numeric_limits<double>::infinity() : 10 * std::log10(peak * peak / mse);
}

double mean_without_worst(std::vector<double> errors, std::size_t left_out) {
  std::sort(errors.begin(), errors.end());
  errors.resize(errors.size() - left_out);
  return std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
}

ImageComparison all_nan(std::uint64_t invalid) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ImageComparison result;
  result.rel_mse = result.rel_mse_trimmed = result.r_mse = result.psnr = result.worst_error = nan;
  result.mean_ratio = {nan, nan, nan};
  result.invalid_values = invalid;
  return result;
}

// Control points of the heat map, evenly spaced over its decades; linear colours.
std::array<float, 3> heat(double error) {
  constexpr std::array<std::array<float, 3>, 5> points{
      {{0, 0, 0}, {0.12f, 0.01f, 0.25f}, {0.6f, 0.03f, 0.05f}, {1, 0.4f, 0.02f}, {1, 1, 1}}};
  if (std::isnan(error)) return {0, 1, 1};
  const double decades = std::clamp(std::log10(std::max(error, 1e-30)), -6.0, 0.0) + 6;
  const double place = decades / 6 * (points.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(place), points.size() - 2);
  const auto weight = static_cast<float>(place - static_cast<double>(first));
  std::array<float, 3> colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = points[first][c] * (1 - weight) + points[first + 1][c] * weight;
  return colour;
}

}  // namespace

Result<ImageComparison> compare_images(const Image& image, const Image& reference) {
  const Result<Pair> pair = paired(image, reference);
  if (!pair) return pair.diagnostics;
  if (const std::uint64_t invalid = count_invalid(*pair)) return all_nan(invalid);

  std::vector<double> errors(pair->pixels);
  for (std::size_t i = 0; i < errors.size(); ++i) errors[i] = pixel_error(*pair, i);
  const auto worst =
      static_cast<std::size_t>(std::max_element(errors.begin(), errors.end()) - errors.begin());

  ImageComparison result;
  result.rel_mse =
      std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
  result.rel_mse_trimmed = mean_without_worst(errors, errors.size() / 1000);
  result.r_mse = std::sqrt(result.rel_mse);
  result.psnr = psnr_of(*pair);
  for (std::size_t c = 0; c < 3; ++c)
    result.mean_ratio[c] = mean_of(pair->x, c) / mean_of(pair->r, c);
  result.worst_x = static_cast<int>(worst % static_cast<std::size_t>(image.width));
  result.worst_y = static_cast<int>(worst / static_cast<std::size_t>(image.width));
  result.worst_error = errors[worst];
  return result;
}

Result<Image> error_heatmap(const Image& image, const Image& reference) {
  const Result<Pair> pair = paired(image, reference);
  if (!pair) return pair.diagnostics;
  Image map(image.width, image.height, {"R", "G", "B"});
  for (std::size_t i = 0; i < pair->pixels; ++i) {
    const std::array<float, 3> colour = heat(pixel_error(*pair, i));
    std::copy(colour.begin(), colour.end(),
              map.values.begin() + static_cast<std::ptrdiff_t>(3 * i));
  }
  return map;
}

}  // namespace candela
