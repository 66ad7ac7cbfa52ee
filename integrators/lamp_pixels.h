// Pixels that lamps are seen in, but not all over. What noise they have is mostly that a camera ray
// meets the lamp or does not, since lamps are much brighter than what they light. More camera rays,
// of which only what lamps themselves send along them counts, cost little (packets of rays that
// nothing is shaded for) and take that noise away (path/seen_lamps.h). They go through that part of
// the pixel alone that the lamps' outlines leave (lamp_view.h).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "integrators/lamp_view.h"

namespace candela {

class LampPixels {
 public:
  LampPixels() = default;  // none
  // `pixels`: by index.
  LampPixels(std::vector<LampView> pixels, int width, std::uint32_t rays_a_sample)
      : pixels_(std::move(pixels)),
        width_(static_cast<std::uint32_t>(width)),
        rays_a_sample_(rays_a_sample) {}

  // How many camera rays look for lamps for each sample of a pixel that is found.
  [[nodiscard]] std::uint32_t rays_a_sample() const { return rays_a_sample_; }
  // Null: the sample's own ray does.
  [[nodiscard]] const LampView* find(int x, int y) const {
    const std::uint32_t index =
        static_cast<std::uint32_t>(y) * width_ + static_cast<std::uint32_t>(x);
    const auto found = std::lower_bound(
        pixels_.begin(), pixels_.end(), index,
        [](const LampView& pixel, std::uint32_t wanted) { return pixel.index < wanted; });
    return found != pixels_.end() && found->index == index ? &*found : nullptr;
  }

 private:
  std::vector<LampView> pixels_;
  std::uint32_t width_ = 0;
  std::uint32_t rays_a_sample_ = 0;
};

}  // namespace candela
