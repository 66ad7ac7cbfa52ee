// z-tests of two noisy images: every pixel, every block, the whole, all channels; corrected for the
// number of tests [Sidak67], so that equal expectations fail once in 1 / level runs.
//
// A pixel sees a local fault (a lost highlight), a block a faint one over an area, the whole a
// light that is a few per cent too dim. Pixels must be independent of each other (no splatting
// filter).
#pragma once

#include <limits>
#include <string>

#include "renderer/image/image.h"

namespace candela::statistics {

// `variance_of_mean`: of each pixel's estimate (sample variance / number of samples), the same
// channels as `mean`. An exact image is one without a variance image.
struct NoisyImage {
  const Image* mean = nullptr;
  const Image* variance_of_mean = nullptr;
};

struct ImageTestOptions {
  double level = 0.01;  // over everything together
  int block = 8;
  // Of a pixel's variance estimate: replicates - 1, or samples - 1. Few of them have heavy tails,
  // which Student's t covers.
  double degrees_of_freedom = std::numeric_limits<double>::infinity();
  // Differences below this share of the larger value count as equal where there is no variance:
  // images of 32-bit floats that were summed in another order.
  double relative_rounding = 1e-6;
};

struct ImageTestResult {
  bool passed = false;
  // Corrected p-values of the three families; each is compared with sidak_level(level, 3).
  double pixel_p_value = 0;
  double block_p_value = 0;
  double whole_p_value = 0;
  int worst_x = 0;  // of the pixel with the least p-value
  int worst_y = 0;
  int worst_channel = 0;
  double worst_z = 0;
  double whole_ratio = 1;  // sum of the first image over sum of the second, all channels
  std::string message;     // a sentence for EXPECT_TRUE(result.passed) << result.message
};

[[nodiscard]] ImageTestResult compare_images(const NoisyImage& image, const NoisyImage& reference,
                                             const ImageTestOptions& options = {});

}  // namespace candela::statistics
