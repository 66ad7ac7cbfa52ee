// The bilinear filter: one small function for each sample type, channel count and decoding, chosen
// once a texture.
#pragma once

#include <cstddef>
#include <span>

#include "renderer/description/scene_description.h"
#include "renderer/image/decode.h"
#include "renderer/math/vec.h"
#include "renderer/texture/footprint.h"

namespace candela {

using description::Encoding;

// Interleaved texels as TexelArray holds them.
struct TexelView {
  const std::byte* samples = nullptr;
  std::int32_t width = 1;
  std::int32_t height = 1;
};

// Decoded to linear. Missing channels as TextureStore::lookup says.
using TexelFilter = Vec4f (*)(const TexelView&, const Footprint&);
// The same bits as TexelFilter's alpha, whatever the encoding.
using AlphaFilter = float (*)(const TexelView&, const Footprint&);
// The first texels of a row, as TexelFilter has them where footprints are single texels.
using RowReader = void (*)(const TexelView&, std::int32_t row, std::span<Vec4f> texels);

struct TexelFilters {
  TexelFilter all = nullptr;
  TexelFilter before_gamma = nullptr;  // likewise, but for LabGamma's power_2_2()
  AlphaFilter alpha = nullptr;
  RowReader row = nullptr;
};

// `channels`: 1..4. With `has_border`, texels at -1 are black and transparent.
[[nodiscard]] TexelFilters texel_filters(SampleType type, int channels, Encoding encoding,
                                         bool has_border);

}  // namespace candela
