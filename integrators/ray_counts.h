// What a render counts of its rays and samples.
#pragma once

#include <cstdint>

namespace candela {

struct RayCounts {
  std::uint64_t camera = 0;
  std::uint64_t indirect = 0;
  std::uint64_t shadow = 0;
  std::uint64_t lamp = 0;     // more camera rays, which look for lamps alone
  std::uint64_t segment = 0;  // between first hits and what other pixels' paths met
};

// What was not done because it could not matter.
struct SkippedCounts {
  std::uint64_t shadow_rays = 0;  // the unoccluded contribution was zero
  std::uint64_t samples = 0;      // of pixels that see nothing but the background, for sure
};

struct InvalidSample {
  int x = 0;
  int y = 0;
  std::uint32_t sample = 0;
};

}  // namespace candela
