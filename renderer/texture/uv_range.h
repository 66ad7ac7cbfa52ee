// Which texels bilinear lookups within a triangle of uvs can touch, and the range of their values.
#pragma once

#include <array>

#include "renderer/texture/footprint.h"
#include "renderer/texture/texels.h"

namespace candela {

// Over the stored values of `channel` (< the file's channels). Wrapped as the lookups are; a
// triangle that is wider than the image, or not finite, counts as all of it.
[[nodiscard]] ValueRange range_over_triangle(TextureFile& file, const std::array<Vec2f, 3>& uvs,
                                             int channel, Wrap wrap);

}  // namespace candela
