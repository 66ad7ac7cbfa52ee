// PNG files, by libpng itself, without the libraries of all formats (codecs.h). Of files that
// passed their guard (guard.h).
#pragma once

#include "renderer/base/result.h"
#include "renderer/image/decode.h"

namespace candela {

// Palettes become RGB, a colour that counts as transparent becomes alpha, and fewer than eight bits
// become eight. Errors and warnings are libpng's words, without the file's name.
[[nodiscard]] Result<ImageHeader> decode_png_header(const Bytes& bytes);

// `header` is the file's own.
[[nodiscard]] Result<DecodedImage> decode_png(const Bytes& bytes, const ImageHeader& header);

}  // namespace candela
