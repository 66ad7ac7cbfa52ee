// Do two renderers have the same expectation? Replicates of one picture by each, and t-tests of
// pixels, blocks and the whole.
//
// Radiance has heavy tails, and nothing bounded like x / (1 + x) may stand for it, since that has
// another expectation at every number of samples. What makes t hold is averaging: a pixel's number
// is a mean of the samples of a replicate, a block's a mean over 64 pixels too. The tails that are
// left make t-tests of differences reject too seldom rather than too often, since differences of
// like estimators are nearly symmetric; so a share of pixels beyond a level that is too large is
// evidence, and blocks and the whole, where the tails are gone, see what pixels do not. Pixels
// enter blocks by their ratio to what both renderers together say of them.
#pragma once

#include <string>
#include <vector>

namespace candela::statistics {

// One renderer's replicates: independent, each of equally many samples. Pixels in rows.
struct Replicates {
  std::string name;
  int width = 0;
  int height = 0;
  std::vector<std::vector<double>> images;
};

struct AgreementOptions {
  double level = 0.01;  // over everything together [Sidak67]
  int block = 8;
  // The share of pixels whose p-value lies below each is compared with it.
  std::vector<double> pixel_levels = {0.05, 0.01, 0.001};
};

struct Agreement {
  bool passed = false;
  double pixels_p_value = 0;  // the least over the pixel levels; each family is corrected
  double blocks_p_value = 0;
  double whole_p_value = 0;
  double whole_ratio = 1;  // of the means, each pixel in units of both images' mean of it
  std::string message;
};

// Equal shapes. Welch's t-test everywhere, with the degrees of freedom that two samples of
// replicates have.
[[nodiscard]] Agreement compare_replicates(Replicates a, Replicates b,
                                           const AgreementOptions& options = {});

}  // namespace candela::statistics
