// How the samples of a render are shared out among its pixels: where a pilot is more wrong, more.
//
// relMSE falls fastest for the same work if a pixel's samples are proportional to the root of its
// part of relMSE over what a sample costs there (Neyman's allocation). A pilot of few samples knows
// that part roughly, so it is smoothed, and some samples go to all pixels alike.
#pragma once

#include <vector>

#include "renderer/film/film.h"

namespace candela {

class SampleDensity {
 public:
  SampleDensity() = default;  // of no picture: not to be asked
  // From the pilot of a whole picture with at least two replicates a pixel.
  explicit SampleDensity(const Film& pilot);

  // Relative to the mean over the picture, which is 1.
  [[nodiscard]] float at(int x, int y) const {
    return values_[static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x)];
  }

  // How many of a pixel's samples belong to the first `mean` a pixel. None of none, else a multiple
  // of the replicates, above 0, that never falls as `mean` rises.
  [[nodiscard]] std::uint32_t samples(int x, int y, std::uint32_t mean) const;

 private:
  std::size_t width_ = 0;
  std::uint32_t replicates_ = 1;
  std::vector<float> values_;
};

}  // namespace candela
