// OpenEXR files, by OpenEXR itself, without the libraries of all formats (codecs.h). Of files that
// passed their guard (guard.h).
#pragma once

#include <optional>

#include "renderer/base/result.h"
#include "renderer/image/decode.h"

namespace candela {

// Of Y, RGB or RGBA in one type, half or float, and no other channels. Empty for all other kinds,
// and for broken files.
[[nodiscard]] std::optional<ImageHeader> plain_exr_header(const Bytes& bytes);

// `header` is the file's own. Errors are OpenEXR's words, without the file's name.
[[nodiscard]] Result<DecodedImage> decode_plain_exr(const Bytes& bytes, const ImageHeader& header);

}  // namespace candela
