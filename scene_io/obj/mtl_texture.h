// The arguments of a map statement: options, then a file name that may hold spaces.
#pragma once

#include <optional>
#include <string>

#include "renderer/base/diagnostic.h"
#include "scene_io/obj/mtl_statements.h"
#include "scene_io/text/cursor.h"

namespace candela::obj {

// Nothing, after an error, where an option is malformed or no file is named. Says where a file was
// found by another letter case; with `warns_of_options`, which options change nothing here.
[[nodiscard]] std::optional<MtlTexture> parse_texture(const std::string& mtl_path,
                                                      const text::Source& source,
                                                      text::Cursor arguments, bool warns_of_options,
                                                      Diagnostics& diagnostics);

}  // namespace candela::obj
