// What a render tells of itself beside its film.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "integrators/path_plan.h"
#include "integrators/ray_counts.h"

namespace candela {

enum class StopReason : std::uint8_t { Samples, Error, Time, Cancelled };

// What came of RenderOptions::guiding.
struct GuidingDone {
  std::uint64_t training_samples = 0;
  std::size_t cells = 0;         // of space; 0: the picture's paths were not guided
  std::size_t guided_cells = 0;  // of them
};

struct RenderStatistics {
  RayCounts rays;
  SkippedCounts skipped;
  std::uint64_t invalid_samples = 0;
  std::optional<InvalidSample> first_invalid;
  std::string kernel;  // the instance that ran
  PathPlan plan;       // the options', but for what is never split, what walks and trials decided
  std::uint64_t roulette_samples = 0;  // that those took
  std::uint64_t reuse_samples = 0;     // that the trial of shared paths took
  GuidingDone guiding;
  StopReason stop = StopReason::Samples;
};

}  // namespace candela
