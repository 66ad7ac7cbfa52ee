// The reader of the pbrt-v4 text format: docs/pbrt.md says what of it is read and how.
#pragma once

#include <string>

#include "renderer/base/result.h"
#include "renderer/description/scene_description.h"

namespace candela::pbrt {

// Reads `path` and every file that it names but images.
[[nodiscard]] Result<description::SceneDescription> read_pbrt(const std::string& path);

// The same with `text` in place of the file's.
[[nodiscard]] Result<description::SceneDescription> parse_pbrt(const std::string& path,
                                                               std::string text);

}  // namespace candela::pbrt
