// How an image rises: central differences, over one texel, of its bilinear filter (texel_filter.h).
//
// Such a difference is the derivative of the image under a filter that is a tent along one axis and
// a quadratic B-spline along the other, so it is continuous. Both read the same 3 x 3 texels.
#pragma once

#include "renderer/texture/texel_filter.h"

namespace candela {

// (d/du, d/dv) of the first channel, decoded to linear.
using SlopeFilter = Vec2f (*)(const TexelView&, Vec2f uv);

// Null where texels do not tell slopes at once: where the filter's values are decoded and not the
// texels, and at borders and mirrors.
[[nodiscard]] SlopeFilter slope_filter(SampleType type, int channels, Encoding encoding, Wrap wrap);

}  // namespace candela
