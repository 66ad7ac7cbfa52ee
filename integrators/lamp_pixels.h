// Pixels that lamps are seen in, but not all over. What noise they have is mostly that a camera ray
// meets the lamp or does not, since lamps are much brighter than what they light. More camera rays,
// of which only what lamps themselves send along them counts, cost little (packets of rays that
// nothing is shaded for) and take that noise away (path/seen_lamps.h).
#pragma once

#include <cstdint>

#include "integrators/pixel_cover.h"

namespace candela {

class LampPixels {
 public:
  LampPixels() = default;  // none
  LampPixels(PixelMask mask, int width, std::uint32_t rays_a_sample)
      : mask_(std::move(mask)),
        width_(static_cast<std::size_t>(width)),
        rays_a_sample_(rays_a_sample) {}

  // How many camera rays look for lamps for each sample of the pixel; 0: the sample's own does.
  [[nodiscard]] std::uint32_t rays_a_sample(int x, int y) const {
    if (mask_.empty()) return 0;
    const std::size_t i = static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x);
    return mask_[i] != 0 ? rays_a_sample_ : 0;
  }

 private:
  PixelMask mask_;
  std::size_t width_ = 0;
  std::uint32_t rays_a_sample_ = 0;
};

}  // namespace candela
