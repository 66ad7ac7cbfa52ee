// How the path kernel spends its effort: where paths multiply and where they end. Right in
// expectation with any.
#pragma once

#include <cstdint>

namespace candela {

// Where neither options nor a trial name another (docs/decisions.md).
inline constexpr float default_roulette_threshold = 0.5f;

struct PathPlan {
  std::uint32_t splitting = 1;  // paths that go on from each first hit
  // Russian roulette ends no path whose throughput is at least this, in (0, 1].
  float roulette_threshold = 1;
};

}  // namespace candela
