// How wrong a picture is, told from the picture alone: relMSE and rMSE as renderer/image/compare.h
// measures them against a reference, in expectation over the seeds.
#pragma once

#include <optional>

#include "renderer/base/progress.h"
#include "renderer/film/film.h"
#include "renderer/film/pixel_errors.h"

namespace candela {

struct Interval {
  double low = 0;
  double high = 0;
};

struct ErrorEstimate {
  double relmse = 0;
  double rmse = 0;         // sqrt(relmse): 0.01 is an error of 1 %
  Interval interval95;     // of relmse, by Student's t
  double heavy_tails = 0;  // share of the pixels where it cannot be trusted (heavy_tails.h)
  // Pixels whose brightness was told by samples that are not in the picture, and how many those are
  // (doubtful_pixels.h).
  std::size_t looked_at = 0;
  std::uint64_t look_samples = 0;
};

// As it is told to people.
[[nodiscard]] StatedError stated_error(const ErrorEstimate& estimate);

// None where some pixel has no two replicates.
[[nodiscard]] std::optional<ErrorEstimate> estimate_error(const Film& film);

// By `errors` of the same film, with two replicates in each pixel at least. `together`: how many
// pixels may be wrong by the same, which makes the interval wider.
[[nodiscard]] ErrorEstimate estimate_error(const Film& film, const PixelErrors& errors,
                                           int together = 1);

}  // namespace candela
