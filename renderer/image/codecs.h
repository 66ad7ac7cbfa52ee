// What OpenImageIO reads and writes, in a module of its own (renderer/image/openimageio/): a
// distribution's OpenImageIO brings some 250 libraries, which take a quarter of a second to load.
// They are loaded when the first image asks for them, and never where none does: what most scenes
// have and most renders write goes without (formats/).
#pragma once

#include <string>

#include "renderer/base/result.h"
#include "renderer/image/decode.h"
#include "renderer/image/encodable.h"
#include "renderer/image/image_format.h"

namespace candela {

// Of a file that passed its guard (formats/guard.h). Errors are sentences without the file's name;
// the libraries' exceptions come through.
struct Codecs {
  Result<ImageHeader> (*decode_header)(ImageFormat, Bytes, const DecodeLimits&);
  Result<DecodedImage> (*decode)(ImageFormat, Bytes, const DecodeLimits&);
  Result<std::string> (*encode)(ImageFormat, const Encodable&);
};

// The module, loaded by the first call. It is looked for where the program's run path says; an
// error tells what the system's loader found in its way.
[[nodiscard]] Result<Codecs> codecs();

// Why it could not be loaded; nothing where it was, or where nobody has asked for it.
[[nodiscard]] Diagnostics why_codecs_are_missing();

}  // namespace candela
