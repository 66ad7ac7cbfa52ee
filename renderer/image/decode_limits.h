// Whether a picture of a claimed size may be decoded.
#pragma once

#include "renderer/image/decode.h"

namespace candela {

// Empty, or an error without the file's name, such as "claims 70000 x 70000 pixels: ...".
[[nodiscard]] Diagnostics check_size(double width, double height, double channels, SampleType type,
                                     const DecodeLimits& limits);

}  // namespace candela
