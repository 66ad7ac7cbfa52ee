// Whether a picture's paths are guided, and by what.
#pragma once

#include <memory>

#include "integrators/guiding/guiding_field.h"
#include "integrators/kernel.h"
#include "integrators/render_options.h"

namespace candela {

struct GuideChoice {
  std::shared_ptr<const GuidingField> field;  // null: they are not
  std::uint64_t training_samples = 0;
};

// Guiding::On: learned from a tenth of the samples. Guiding::Auto: first from 2 %; then a trial
// renders a few tiles, with and without the guide (1 % of the samples), and only where
// guided paths reach an error in clearly less time it goes on to learn from 8 %. Pictures with too
// few samples are not guided, nor are those of which `is_over` says that there is no time to learn.
// Else the same for any crop and threads.
[[nodiscard]] GuideChoice choose_guide(const RenderOptions& options,
                                       const TileFunction& render_tile,
                                       const std::function<bool()>& is_over);

}  // namespace candela
