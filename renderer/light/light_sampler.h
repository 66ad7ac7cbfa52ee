// Picks lights for next-event estimation.
//
// With at most `delta_limit` delta lights each of them is sampled at every hit, and one more light
// is picked by power among the rest (triangles, environment). With more delta lights all are picked
// by power.
#pragma once

#include <cstdint>
#include <vector>

namespace candela {

struct LightSampler {
  static constexpr std::size_t delta_limit = 4;

  std::vector<std::uint32_t> always;  // lights that are sampled at every hit
};

}  // namespace candela
