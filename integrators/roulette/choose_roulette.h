// Where Russian roulette begins to end paths, by what it saves and what noise it adds: the more the
// picture's noise is that of first hits, the more paths may end [Bolin97; Rath22].
#pragma once

#include "integrators/kernel.h"
#include "integrators/render_options.h"

namespace candela {

struct RouletteChoice {
  PathPlan plan;
  std::uint64_t samples = 0;  // that it took, which the picture does not use
};

// The options' plan with another roulette, by walks from pixels all over the picture, whatever the
// crop: 1 in 400 of its samples, at most 8192; none of pictures whose share is below 1024. The
// options' own where `is_over` says that there is no time for it.
[[nodiscard]] RouletteChoice choose_roulette(const RenderOptions& options,
                                             const TileFunction& render_tile,
                                             const std::function<bool()>& is_over);

}  // namespace candela
