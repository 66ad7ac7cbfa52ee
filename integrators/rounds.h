// How many samples a pixel come next. Rounds end where the error is looked at; within them passes
// of a few samples end where a render can be stopped.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

#include "renderer/sampling/sampler_block.h"

namespace candela {

// Half-open range of sample indices.
struct SampleRange {
  std::uint32_t first = 0;
  std::uint32_t end = 0;
  [[nodiscard]] bool is_empty() const { return first == end; }
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

// Of a round that is followed by a decision; and by how much less it may grow for whole blocks.
inline constexpr double largest_growth = 1.3;
inline constexpr double smallest_growth = 1.1;
// Of a picture that needs more times its samples than this a round need not be followed by one.
inline constexpr double far_goal = 4;

// Samples that are traced together (trace_block.h): ranges that are cut at their multiples are
// the fastest.
inline constexpr std::uint32_t whole_block = block_size;

// Where the round after `done` samples ends: multiples of the replicates, so that all hold equally
// many, and of whole blocks, too: at once where there is no goal, else as soon as the growth
// allows. Four samples a replicate first. Then the picture doubles, but near a goal it grows by 1.3
// at most, and not beyond what the goal seems to need.
[[nodiscard]] inline std::uint32_t round_end(std::uint32_t done, std::uint32_t replicates,
                                             std::uint32_t most,
                                             const std::optional<ErrorGoal>& goal) {
  const std::uint32_t whole = std::lcm(replicates, whole_block);
  const std::uint32_t fewest = 4 * replicates;
  const std::uint32_t first = goal ? fewest : (fewest + whole - 1) / whole * whole;
  if (done < first) return std::min(first, most);
  const double now = done;
  const double wanted = goal ? samples_for(*goal, done) : 0;
  const bool is_far = !goal || (std::isfinite(wanted) && wanted > far_goal * now);
  const double most_grown = (is_far ? 2 : largest_growth) * now;
  const auto multiple_below = [](double n, double step) { return std::floor(n / step) * step; };
  const double step =
      multiple_below(most_grown, whole) > smallest_growth * now ? whole : replicates;
  const double needed = goal ? std::ceil(wanted / step) * step : multiple_below(most_grown, step);
  const double end = std::max(std::min(needed, multiple_below(most_grown, step)),
                              multiple_below(now, step) + step);
  return end < most ? static_cast<std::uint32_t>(end) : most;
}

// Block by block; of a long render one sample first, so that what an interruption leaves is whole
// early.
[[nodiscard]] inline SampleRange next_pass(std::uint32_t done, std::uint32_t end, bool is_long) {
  const std::uint32_t block_end = is_long && done == 0 ? 1 : (done / whole_block + 1) * whole_block;
  return {done, std::min(block_end, end)};
}

}  // namespace candela
