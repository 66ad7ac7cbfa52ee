// How far an image is from a reference: linear Rec.709, no tone mapping, no pixel left out.
#pragma once

#include <array>
#include <cstdint>

#include "renderer/base/result.h"
#include "renderer/image/image.h"

namespace candela {

// Relative errors have relmse_epsilon() (relmse.h) of mean(r), over all pixels and channels.
//
// A pixel with a value that is not finite, in either image, has infinite error: relmse, mse and
// rmse are infinite then, psnr is -infinity, and the trimmed mean is finite only where such pixels
// are fewer than it leaves out. Means are over finite values.
struct ImageComparison {
  int width = 0;
  int height = 0;
  double relmse = 0;          // mean of the pixels' relative errors
  double relmse_trimmed = 0;  // the same without the worst 0.1 % of the pixels (rounded down)
  double rmse = 0;            // sqrt(relmse): 0.01 is an error of 1 %
  double mse = 0;             // mean of (x - r)^2
  double psnr = 0;            // 10 log10(max(r)^2 / mse), in dB; infinite for equal images
  std::array<double, 3> mean_ratio{1, 1, 1};  // mean(x) / mean(r) of R, G, B; 1 for 0 / 0
  int worst_x = 0;
  int worst_y = 0;
  double worst_error = 0;               // the worst pixel's mean of (x - r)^2 / (r^2 + epsilon)
  std::array<double, 3> worst_image{};  // its colours
  std::array<double, 3> worst_reference{};
  std::uint64_t invalid_values = 0;  // NaN or infinite, in both images together
  std::uint64_t invalid_in_image = 0;
  std::uint64_t invalid_in_reference = 0;
};

// Of the channels R, G, B, or of the one channel that each has (grey counts as three equal ones);
// alpha and layers are not compared. Different sizes or missing channels are an error.
[[nodiscard]] Result<ImageComparison> compare_images(const Image& image, const Image& reference);

// Each pixel's relative error as a colour: black to white over log10(error) from -6 to 2, on a path
// of evenly rising lightness and turning hue (violet, blue, green, yellow) in Oklab [Ottosson20].
// So 1e-2, an error of 10 %, lies in the middle. Pixels that are not finite are red. The colours
// are linear: write them with ToneMap::Srgb.
[[nodiscard]] Result<Image> error_heatmap(const Image& image, const Image& reference);

// The colour of a place in [0, 1] on that path, linear Rec.709.
[[nodiscard]] std::array<float, 3> heat_colour(double place);

}  // namespace candela
