// How the samples of a render are shared out among its pixels: where a pilot is more wrong, more.
//
// relMSE falls fastest for the same work if a pixel's samples are proportional to the root of its
// part of relMSE over what a sample costs there (Neyman's allocation). A pilot of few samples knows
// that root roughly, so it is a mean over pixels near by, and some samples go to all pixels alike.
//
// The pilot's samples stay in the picture, and those that follow continue its sequences. That is
// unbiased since no pixel's own samples have a say in how many it gets: pixels are coloured as a
// chessboard, and what is dealt out to one colour is decided by the pilot's pixels of the other
// alone, which have random numbers of their own.
#pragma once

#include <array>
#include <vector>

#include "renderer/film/film.h"

namespace candela {

// 0 or 1.
[[nodiscard]] inline std::size_t chessboard_colour(int x, int y) {
  return static_cast<std::size_t>(x + y) & 1;
}

class SampleDensity {
 public:
  SampleDensity() = default;  // of no picture: not to be asked
  // From a pilot of at least two pixels a side, with at least two replicates (or pieces) and the
  // same number of samples in every pixel. `mean` and all that is relative to one is of the pilot's
  // pixels, and no others may be asked for. Pixels of a colour in an aligned square of a `side`
  // get the same where they want nearly the same: shared paths (integrators/path/reuse_groups.h)
  // then are of whole sets of well-spread samples.
  explicit SampleDensity(const Film& pilot, int side = 1);

  // What making one takes for each pixel, at least, beside the pilot.
  static constexpr std::size_t bytes_a_pixel =
      3 * sizeof(float) + 2 * sizeof(double);  // values, wishes, theirs by colour; what each says

  // Relative to the mean over the pixels, which is 1 but for what the colours differ by.
  [[nodiscard]] float at(int x, int y) const { return values_[index(x, y)]; }

  // What the values of each colour are multiplied by for a mean of samples, at least the pilot's.
  using Scales = std::array<double, 2>;
  [[nodiscard]] Scales scales(std::uint32_t mean) const;

  // How many samples, the pilot's first, a pixel gets: the pilot's, or of each of its sequences as
  // many as are evenly spread (sampling/even_counts.h). It never falls as the mean rises.
  [[nodiscard]] std::uint32_t samples(int x, int y, const Scales& scales) const;

 private:
  // The wishes (wish_at) of a colour's pixels, rising.
  using Wishes = std::vector<float>;
  void even_out_squares();
  void even_out(const PixelRect& square, std::size_t colour);
  [[nodiscard]] float wish_at(int x, int y) const;
  // By the pixels of one colour: scales(), and what a scale gives all of them together.
  [[nodiscard]] double scale_of(const Wishes& wishes, std::uint32_t mean) const;
  [[nodiscard]] double sum_of_samples(const Wishes& wishes, double scale) const;
  [[nodiscard]] std::size_t index(int x, int y) const { return rect_.index(x, y); }

  PixelRect rect_;
  int side_ = 1;
  std::uint32_t sequences_ = 1;
  std::uint32_t pilot_samples_ = 0;
  std::vector<float> values_;
  std::vector<float> wish_of_pixel_;
  std::array<Wishes, 2> wishes_;
};

}  // namespace candela
