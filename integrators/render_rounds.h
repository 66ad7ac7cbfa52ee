// The render loop: rounds of passes over tiles until a stop rule is met.
#pragma once

#include <optional>

#include "integrators/kernel.h"
#include "integrators/render.h"
#include "integrators/roulette/choose_roulette.h"

namespace candela {

struct RoundsDone {
  TileCounts counts;
  StopReason stop = StopReason::Samples;
  RouletteChoice roulette;
  GuidingDone guiding;
  std::optional<ErrorEstimate> error;  // of the film as it is now
};

[[nodiscard]] RoundsDone render_rounds(const RenderOptions& options,
                                       const TileFunction& render_tile, Film& film,
                                       ProgressSink* progress, const CancelFlag* cancel);

}  // namespace candela
