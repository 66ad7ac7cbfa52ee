// The render loop: rounds of passes over tiles until a stop rule is met.
#pragma once

#include <optional>

#include "integrators/kernel.h"
#include "integrators/render_options.h"
#include "integrators/render_statistics.h"
#include "integrators/time_budget.h"
#include "renderer/base/progress.h"
#include "renderer/film/error_estimate.h"

namespace candela {

struct RoundsDone {
  TileCounts counts;
  StopReason stop = StopReason::Samples;
  PathPlan plan;  // the options', but for what was chosen
  std::uint64_t roulette_samples = 0;
  std::uint64_t reuse_samples = 0;
  GuidingDone guiding;
  std::optional<ErrorEstimate> error;  // of the film as it is now; none: RenderResult says when
};

// `has_light`: whether there is any to be met. Then a picture that has met none knows nothing of
// its error, and states none.
// `start`: of the time that there is.
[[nodiscard]] RoundsDone render_rounds(
    const RenderOptions& options, const TileFunction& render_tile, Film& film,
    ProgressSink* progress, const CancelFlag* cancel, bool has_light = true,
    TimeBudget::Clock::time_point start = TimeBudget::Clock::now());

}  // namespace candela
