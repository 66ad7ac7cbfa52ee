// Portable float maps, without the libraries of all formats (codecs.h): "PF" or "Pf", width, height
// and scale as text, then rows of floats from the bottom.
#pragma once

#include <optional>

#include "renderer/base/result.h"
#include "renderer/image/decode.h"

namespace candela {

// Of maps whose scale is 1 (big endian) or -1 (little endian) and that hold all their rows. Empty
// for all other kinds of PNM, and for broken files.
[[nodiscard]] std::optional<ImageHeader> plain_pfm_header(const Bytes& bytes);

// `header` is the file's own.
[[nodiscard]] Result<DecodedImage> decode_plain_pfm(const Bytes& bytes, const ImageHeader& header);

}  // namespace candela
