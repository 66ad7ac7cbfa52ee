// The range of what bilinear lookups can give, by cells of the image.
#pragma once

#include <vector>

#include "renderer/texture/footprint.h"
#include "renderer/texture/texels.h"

namespace candela {

// Over the stored values of `channel` (< the file's channels), one range for all footprints whose
// first column and row lie in one cell of `cell_side` x `cell_side` texels; row by row. `wrap` is
// not Wrap::Black, whose footprints may begin outside.
[[nodiscard]] std::vector<ValueRange> footprint_ranges(const TexelArray& texels, int channel,
                                                       Wrap wrap, int cell_side);

}  // namespace candela
