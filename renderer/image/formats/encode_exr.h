// OpenEXR files, by OpenEXR itself: what a render writes, without the libraries of all formats.
#pragma once

#include <string>

#include "renderer/base/result.h"
#include "renderer/image/encodable.h"

namespace candela {

// Half or float samples, one part of scan lines, ZIP. "DateTime" is called "capDate" there and is
// now where it is not given. Errors are OpenEXR's words.
[[nodiscard]] Result<std::string> encode_exr(const Encodable& image);

}  // namespace candela
