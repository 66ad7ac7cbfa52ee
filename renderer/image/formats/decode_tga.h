// Truevision TGA, read by ourselves: OpenImageIO 2.4.7's reader crashes on colour indices beyond
// the palette (CVE-2023-22845) and trusts the footer's offsets (CVE-2023-24473).
#pragma once

#include "renderer/base/result.h"
#include "renderer/image/decode.h"

namespace candela {

// Types 1, 2, 3 and their run-length-encoded twins 9, 10, 11; 8-bit grey, grey and alpha in 16
// bits, 15 and 16-bit colour without its attribute bit, 24 and 32-bit colour; palettes of 15 to 32
// bits. Footers and what they point to are not read. Errors are without the file's name.
[[nodiscard]] Result<ImageHeader> decode_tga_header(const Bytes& bytes);
[[nodiscard]] Result<DecodedImage> decode_tga(const Bytes& bytes);

}  // namespace candela
