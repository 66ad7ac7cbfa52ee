// An image file made in memory by OpenImageIO.
#pragma once

#include <string>

#include "renderer/base/result.h"
#include "renderer/image/encodable.h"
#include "renderer/image/image_format.h"

namespace candela {

// JPEG, HDR or TIFF. Errors are OpenImageIO's words.
[[nodiscard]] Result<std::string> encode_file(ImageFormat format, const Encodable& image);

}  // namespace candela
