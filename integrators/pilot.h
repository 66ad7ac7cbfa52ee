// The first samples of a render with adaptive sampling: by them the others are dealt out
// (renderer/film/sample_density.h).
#pragma once

#include "integrators/render_options.h"

namespace candela {

struct Pilot {
  // Its pixels: the whole picture, so that a crop's get what they get there; where the error or the
  // time may end the render, and a crop has counts of its own, no more than the crop needs.
  PixelRect rect;
  std::uint32_t samples = 0;  // a pixel; 0: there is none
  // By which its noise is told: replicates, or pieces of a pixel's one sequence.
  std::uint32_t sums = 0;

  // Whether a film of such pixels and replicates can hold it.
  [[nodiscard]] bool fits(const PixelRect& crop, std::uint32_t replicates) const {
    return rect == crop && sums == replicates;
  }
};

[[nodiscard]] Pilot pilot_of(const RenderOptions& options);

// A pixel, below which there is none; and whether neighbours on two sides can decide for a pixel.
[[nodiscard]] std::uint32_t least_samples_for_pilot(const RenderOptions& options);
[[nodiscard]] bool is_wide_enough_for_pilot(const RenderOptions& options);

}  // namespace candela
