// An image file in memory, decoded by OpenImageIO.
#pragma once

#include "renderer/base/result.h"
#include "renderer/image/decode.h"
#include "renderer/image/image_format.h"

namespace candela {

// Of a file that passed its guard. Errors are sentences without the file's name; warnings tell what
// was converted or passed over.
[[nodiscard]] Result<ImageHeader> decode_file_header(ImageFormat format, Bytes bytes,
                                                     const DecodeLimits& limits);
[[nodiscard]] Result<DecodedImage> decode_file(ImageFormat format, Bytes bytes,
                                               const DecodeLimits& limits);

}  // namespace candela
