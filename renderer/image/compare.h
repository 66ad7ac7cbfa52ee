// How wrong an image is, held against a reference.
#pragma once

#include <array>
#include <cstdint>

#include "renderer/base/result.h"
#include "renderer/image/image.h"

namespace candela {

// Over all pixels and the channels R, G, B; nothing is left out but in `rel_mse_trimmed`.
struct ImageComparison {
  double rel_mse = 0;          // mean of (x - r)^2 / (r^2 + eps), eps = 10^-2 mean(r)^2
  double rel_mse_trimmed = 0;  // without the worst 0.1 % of the pixels (rounded down)
  double r_mse = 0;            // sqrt(rel_mse)
  double psnr = 0;             // 10 log10(max(r)^2 / mean (x - r)^2) in dB; infinite where equal
  std::array<double, 3> mean_ratio{};  // mean of x over mean of r, by channel; NaN: both are black
  int worst_x = 0;
  int worst_y = 0;
  double worst_error = 0;            // the worst pixel's mean of (x - r)^2 / (r^2 + eps)
  std::uint64_t invalid_values = 0;  // NaN or Inf in either image: every figure above is NaN then
};

// Images of one size with channels R G B (a single channel stands for all three). The error names
// what does not fit.
[[nodiscard]] Result<ImageComparison> compare_images(const Image& image, const Image& reference);

// R G B: each pixel's mean of (x - r)^2 / (r^2 + eps) on a logarithmic scale of colours from black
// (10^-6 and less) over violet, red and orange to white (1 and more); cyan: not a number.
[[nodiscard]] Result<Image> error_heatmap(const Image& image, const Image& reference);

}  // namespace candela
