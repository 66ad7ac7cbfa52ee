// Sums over the pixels next to each that look like it, weighted by how much they do
// [Rousselle12, section 4].
#pragma once

#include "renderer/film/pixel_planes.h"

namespace candela {

// What is compared, as well as each channel, since two colours may be one grey: the grey level of
// each pixel and its variance; 1 in `counts` where there is a pixel, and 0 beyond the picture.
struct GreyPixels {
  std::size_t width = 0;  // of the rectangle
  Plane levels;
  Plane variances;
  Plane counts;
};

// What is summed up, and compared, of one channel.
struct ChannelPixels {
  Plane means;
  Plane variances;
  Plane squares;  // mean^2 - variance: of what the means would be without noise
};

// With weights w over the neighbours, of a run of pixels.
struct AlikeSums {
  Plane weights;   // w
  Planes means;    // w mean
  Planes squares;  // w square
  Planes noises;   // w^2 variance
};

// How far from the rectangle's edges pixels must be to have sums.
inline constexpr int alike_margin = 4;

// Of the `count` pixels from the one at `first` on, row by row.
[[nodiscard]] AlikeSums alike_sums(const GreyPixels& grey,
                                   const std::array<ChannelPixels, 3>& channels, std::size_t first,
                                   std::size_t count);

}  // namespace candela
