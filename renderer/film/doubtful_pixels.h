// Pixels that the picture's error hangs on and whose brightness it does not tell.
//
// Where one replicate of four has met light that is rare and bright, the variance of the pixel's
// mean is right on average, but not what it is held against: neither the pixel nor its neighbours
// know how bright it is in truth, by factors of a hundred. More samples do, if they are not of the
// picture, whose noise they must not share.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/film/film.h"
#include "renderer/film/pixel_errors.h"

namespace candela {

struct DoubtfulPixel {
  std::size_t index = 0;     // in the film
  std::uint64_t wanted = 0;  // samples that would tell how bright it is
};

// The worst first.
[[nodiscard]] std::vector<DoubtfulPixel> doubtful_pixels(const Film& film,
                                                         const PixelErrors& errors);

}  // namespace candela
