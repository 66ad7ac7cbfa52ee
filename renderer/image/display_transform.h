// Linear radiance to the 8 bits of a display.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/image/image.h"
#include "renderer/image/image_io.h"

namespace candela {

// One number, 0..255, rounded to the nearest. NaN and negatives are 0, what lies above the
// displayable range is 255.
[[nodiscard]] std::uint8_t display_value(double linear, const DisplayTransform& display);

// 3 bytes a pixel, or 4 where the picture has a channel "A" and `keep_alpha`: then the colour is
// divided by alpha, since 8-bit files hold it straight. Else premultiplied colour stands as it is,
// over black. Colour comes from "R", "G", "B", or from the first channel where "R" is missing.
[[nodiscard]] std::vector<std::uint8_t> display_bytes(const Image& image,
                                                      const DisplayTransform& display,
                                                      bool keep_alpha);

// Which channels hold red, green, blue and alpha (-1: none).
struct ColourChannels {
  std::array<int, 3> rgb{0, 0, 0};
  int alpha = -1;
};
[[nodiscard]] ColourChannels colour_channels(const Image& image);

}  // namespace candela
