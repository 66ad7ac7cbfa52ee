// What each pixel brings to the error of a picture, told from the picture alone.
#pragma once

#include <optional>
#include <vector>

#include "renderer/film/film.h"

namespace candela {

// Of relMSE (renderer/image/compare.h) times the number of pixels, in rows from the top: very noisy
// for each pixel. The variance in it is unbiased, the level that it is held against is a guess. All
// 0 for a black picture.
struct PixelErrors {
  std::vector<double> errors;
  double epsilon = 0;  // relMSE's, of this picture

  [[nodiscard]] bool is_black() const { return !(epsilon > 0); }
};

// None where some pixel has no two replicates.
[[nodiscard]] std::optional<PixelErrors> estimate_pixel_errors(const Film& film);

// What stands for the reference in a pixel, and its variance.
struct PixelLevel {
  Vec3d mean{0.0};
  Vec3d variance{0.0};
};

// The error of the i-th pixel where its level is known otherwise, from samples that are not in the
// picture.
[[nodiscard]] double error_at_level(const Film& film, std::size_t i, const PixelLevel& level,
                                    double epsilon);

}  // namespace candela
