// JPEG files, by libjpeg itself, without the libraries of all formats (codecs.h). Of files that
// passed their guard (guard.h).
#pragma once

#include <optional>

#include "renderer/base/result.h"
#include "renderer/image/decode.h"

namespace candela {

// What the frame says of a picture of grey or RGB in 8 bits, Huffman-coded, without a decoder:
// libjpeg reads all scans of a progressive file before it is open, nearly the time of decoding it.
// Empty for all other kinds (printing inks), and for broken files.
[[nodiscard]] std::optional<ImageHeader> plain_jpeg_header(const Bytes& bytes);

// `header` is the file's own. Errors and warnings are libjpeg's words, without the file's name.
[[nodiscard]] Result<DecodedImage> decode_plain_jpeg(const Bytes& bytes, const ImageHeader& header);

}  // namespace candela
