// What a JPEG's frame says of its picture, without a decoder: libjpeg reads all scans of a
// progressive file before it is open, nearly the time of decoding it.
#pragma once

#include <optional>
#include <span>

#include "renderer/image/decode.h"

namespace candela {

// Of grey and RGB in 8 bits, Huffman-coded. Empty for all other kinds, and for broken files.
[[nodiscard]] std::optional<ImageHeader> plain_jpeg_header(std::span<const unsigned char> bytes);

}  // namespace candela
