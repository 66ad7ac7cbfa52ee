#include "renderer/light/light_ranges.h"

#include <bit>

namespace candela {

LightRanges::LightRanges(std::vector<LightRange> ranges) : ranges_(std::move(ranges)) {
  if (ranges_.empty()) return;
  // Long lists shall stay in the cache, short ones be searched at once.
  constexpr std::size_t is_long = 64;
  const std::size_t cells = ranges_.size() > is_long ? ranges_.size() / 2 : 2 * ranges_.size();
  const auto guide_bits = static_cast<unsigned>(std::bit_width(cells));
  guide_shift_ = 32 - guide_bits;
  std::uint16_t index = 0;
  for (std::uint64_t cell = 0; cell <= std::uint64_t{1} << guide_bits; ++cell) {
    while (index + 1u < ranges_.size() && ranges_[index + 1u].first <= cell << guide_shift_)
      ++index;
    guide_.push_back(index);
  }
}

}  // namespace candela
