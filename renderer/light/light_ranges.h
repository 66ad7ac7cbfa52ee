// A choice among few lights by inversion, neighbours side by side: what is left of the number is
// good for a place on the light, so that points that are well spread over [0, 1)^2 are well spread
// over all lights together, such as the two triangles of a lamp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/math/constants.h"

namespace candela {

// What picks a light: 32-bit numbers from `first` up to the next light's.
struct LightRange {
  std::uint32_t first = 0;
  std::uint32_t light = 0;
  float inverse_width = 0;
  float probability = 0;  // > 0

  // What is left of the number that chose, in [0, 1).
  [[nodiscard]] float rest(std::uint32_t bits) const {
    return std::min(static_cast<float>(bits - first) * inverse_width, one_minus_epsilon);
  }
};

class LightRanges {
 public:
  LightRanges() = default;
  // Ranges in order that cover all 32-bit numbers; less than 2^16 of them.
  explicit LightRanges(std::vector<LightRange> ranges);

  [[nodiscard]] bool is_empty() const { return ranges_.empty(); }
  [[nodiscard]] std::span<const LightRange> ranges() const { return ranges_; }

  // Not to be called where there is none.
  [[nodiscard]] const LightRange& pick(std::uint32_t bits) const {
    const std::uint32_t cell = bits >> guide_shift_;
    std::size_t index = guide_[cell];
    for (std::size_t length = guide_[cell + 1] - index + 1; length > 1;) {
      const std::size_t half = length / 2;
      index += ranges_[index + half].first <= bits ? half : 0;
      length -= half;
    }
    return ranges_[index];
  }

 private:
  std::vector<LightRange> ranges_;
  // By the leading bits of a number: where the search for its range begins, and by the next entry
  // where it ends [Chen74].
  std::vector<std::uint16_t> guide_;
  unsigned guide_shift_ = 0;
};

}  // namespace candela
