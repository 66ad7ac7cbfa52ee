// Whether options are what render_options.h says of them.
#pragma once

#include "integrators/render_options.h"
#include "renderer/base/diagnostic.h"

namespace candela {

// An error without a place for each that is not: sizes, counts and numbers out of their range, a
// camera that the scene has not, a crop that is not within the picture.
[[nodiscard]] Diagnostics check_options(const Scene& scene, const RenderOptions& options);

// Throws std::invalid_argument with the first of them.
void require_valid(const Scene& scene, const RenderOptions& options);

}  // namespace candela
