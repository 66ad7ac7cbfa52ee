// compile()'s step for cut-outs, after materials and geometry: a coverage grid for each opacity map
// that visibility asks.
#pragma once

#include "renderer/scene/scene.h"

namespace candela {

void compile_coverage(Scene& scene);

}  // namespace candela
