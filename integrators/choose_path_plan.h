// How many paths shall go on from a first hit and when roulette may end them, found by a trial.
#pragma once

#include "integrators/kernel.h"
#include "integrators/path_plan.h"
#include "integrators/render.h"

namespace candela {

// What the options say; else one path, and the default threshold.
[[nodiscard]] PathPlan plan_without_trial(const RenderOptions& options);

// With k paths from each first hit a camera sample's variance is A + B / k, and what it costs
// c0 + c1 k: what comes before and with the first hit, and what after. A trial of a few tiles,
// spread over the whole picture, with k = 1 and k = 4 from the same first hits tells all four; a
// third, with k = 1 and a low roulette threshold, B and c1 of that. What a given error costs, the
// product, is least at k = sqrt(B / A * c0 / c1) [Rath22]; of 1, 2 and 4, with either threshold,
// the best is taken. What the options fix stays. As without a trial where 4.5 % of the paths are
// too few for one, and where next to nothing is gained. The same for any crop and threads. `cancel`
// may be null.
[[nodiscard]] PathPlan choose_path_plan(const RenderOptions& options,
                                        const TileFunction& render_tile, const CancelFlag* cancel);

}  // namespace candela
