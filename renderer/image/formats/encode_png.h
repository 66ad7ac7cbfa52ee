// PNG files, by libpng itself, without the libraries of all formats (codecs.h).
#pragma once

#include <string>

#include "renderer/base/result.h"
#include "renderer/image/encodable.h"

namespace candela {

// One to four channels of eight or sixteen bits; alpha, where there is any, is straight. Of the
// attributes "DateTime" becomes the time of the last change, and "oiio:ColorSpace" of "sRGB" is
// told with the primaries and the gamma that go with it. Errors are libpng's words.
[[nodiscard]] Result<std::string> encode_png(const Encodable& image);

}  // namespace candela
