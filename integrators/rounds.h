// How many samples a pixel come next. Rounds end where the error is looked at; within them passes
// of a few samples end where a render can be stopped.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace candela {

// Half-open range of sample indices.
struct SampleRange {
  std::uint32_t first = 0;
  std::uint32_t end = 0;
};

// The error after `samples` a pixel, and what it shall be.
struct ErrorGoal {
  double relmse = 0;
  double wanted = 0;
};

// The samples that relMSE falls to the goal with, were it proportional to 1 / samples.
[[nodiscard]] inline double samples_for(const ErrorGoal& goal, std::uint32_t samples) {
  return static_cast<double>(samples) * goal.relmse / goal.wanted;
}

inline constexpr double largest_growth = 1.3;  // of a round that is followed by a decision

// Where the round after `done` samples ends: multiples of the replicates, so that all hold equally
// many. Four samples a replicate first. Towards a goal the picture then grows by 1.3 at most, and
// not beyond what the goal seems to need; else it doubles.
[[nodiscard]] inline std::uint32_t round_end(std::uint32_t done, std::uint32_t replicates,
                                             std::uint32_t most,
                                             const std::optional<ErrorGoal>& goal) {
  constexpr std::uint32_t first_samples = 4;  // a replicate
  if (done < first_samples * replicates) return std::min(first_samples * replicates, most);
  const double now = done;
  const double grown = std::floor((goal ? largest_growth : 2) * now / replicates) * replicates;
  const double needed =
      goal ? std::ceil(samples_for(*goal, done) / replicates) * replicates : grown;
  const double end = std::max(std::min(needed, grown), now + replicates);
  return end < most ? static_cast<std::uint32_t>(end) : most;
}

// One sample first, so that an interrupted picture is whole early; then up to multiples of sixteen.
[[nodiscard]] inline SampleRange next_pass(std::uint32_t done, std::uint32_t end) {
  constexpr std::uint32_t block = 16;
  const std::uint32_t block_end = done == 0 ? 1 : (done / block + 1) * block;
  return {done, std::min(block_end, end)};
}

}  // namespace candela
