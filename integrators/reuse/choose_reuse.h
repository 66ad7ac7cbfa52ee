// Whether pixels should share what their paths find (path/path_reuse.h), by what noise it takes
// away and what it costs: a few groups of pixels are rendered, whose samples tell at once what they
// are with and without what is shared.
#pragma once

#include "integrators/kernel.h"
#include "integrators/render_options.h"

namespace candela {

struct ReuseChoice {
  bool reuses_paths = false;
  std::uint64_t samples = 0;  // that it took, which the picture does not use
};

// `plan`: with the picture's roulette. By groups all over the picture, whatever the crop: eight,
// and twice as many until what they say is clear, at most 64 and 1 in 100 of the picture's samples.
// Pictures of which eight are more do not share, nor do those of less than a block of samples a
// pixel, or of which `is_over` says that there is no time to ask.
[[nodiscard]] ReuseChoice choose_reuse(const RenderOptions& options, PathPlan plan,
                                       const TileFunction& render_tile,
                                       const std::function<bool()>& is_over);

}  // namespace candela
