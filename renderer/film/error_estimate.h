// How wrong a picture is, told from the picture alone: relMSE and rMSE as renderer/image/compare.h
// measures them against a reference, in expectation over the seeds.
#pragma once

#include <optional>

#include "renderer/film/film.h"

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
};

// None where some pixel has no two replicates.
[[nodiscard]] std::optional<ErrorEstimate> estimate_error(const Film& film);

}  // namespace candela
