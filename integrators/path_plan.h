// How the path kernel spends its effort: where paths multiply and where they end. Right in
// expectation with any; what pays: docs/decisions.md, "Splitting, by the same time".
#pragma once

#include <algorithm>
#include <cstdint>

namespace candela {

// Of renders that are not told another (docs/decisions.md).
inline constexpr float default_roulette_threshold = 0.5f;
inline constexpr std::uint32_t max_splitting = 64;

// Russian roulette as a path asks it when it leaves a surface.
struct Roulette {
  float inverse_threshold = 1;
  std::uint32_t first_bounce = 2;  // 0: it may end a path at its first hit
};

struct PathPlan {
  std::uint32_t splitting = 1;  // paths that go on from each first hit, up to max_splitting
  // Russian roulette ends no path whose throughput is at least this, in (0, 1], nor any that leaves
  // an earlier hit than this one (from 0).
  float roulette_threshold = 1;
  std::uint32_t first_roulette_bounce = Roulette{}.first_bounce;

  // Pixels share what their paths find behind first hits (path/path_reuse.h), which roulette then
  // leaves alone.
  bool reuses_paths = false;

  [[nodiscard]] Roulette roulette() const {
    return {1 / roulette_threshold, std::max(first_roulette_bounce, reuses_paths ? 1u : 0u)};
  }
};

}  // namespace candela
