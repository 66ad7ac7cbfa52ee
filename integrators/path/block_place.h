// Which samples the blocks of sixteen have.
#pragma once

#include "integrators/path/camera_rays.h"
#include "integrators/rounds.h"

namespace candela {

struct BlockPlace {
  PixelLanes pixels;
  Lanes<std::uint32_t> samples;  // of the pixels
  LaneMask lanes;                // those that are filled
};

// Consecutive ones of a pixel, from `first` on.
[[nodiscard]] inline BlockPlace place_in_pixel(const RenderOptions& options, int x, int y,
                                               std::uint32_t first, LaneMask lanes) {
  BlockPlace place{pixel_lanes_of(options), {}, lanes};
  place.pixels.x.fill(x);
  place.pixels.y.fill(y);
  for (std::uint32_t i = 0; i < block_size; ++i) place.samples[i] = first + i;
  return place;
}

// Lanes of the block at `base` whose samples lie in the range, which ends after `base`.
[[nodiscard]] inline LaneMask lanes_in(std::uint32_t base, const SampleRange& range) {
  const LaneMask from_first = range.first > base ? all_lanes << (range.first - base) : all_lanes;
  const LaneMask to_end =
      range.end - base < block_size ? (1u << (range.end - base)) - 1 : all_lanes;
  return from_first & to_end & all_lanes;
}

// Where the block begins that has the first sample of a range.
[[nodiscard]] inline std::uint32_t first_block(const SampleRange& range) {
  return range.first & ~(block_size - 1);
}

}  // namespace candela
