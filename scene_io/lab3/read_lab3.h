// lab3 YAML, and candela's extension of it -> SceneDescription (docs/scene_format.md).
#pragma once

#include <string>
#include <string_view>

#include "renderer/base/result.h"
#include "renderer/description/scene_description.h"
#include "scene_io/load_options.h"

namespace candela::lab3 {

// Reads the file at `path` and the meshes that it names.
[[nodiscard]] Result<description::SceneDescription> read_lab3(const std::string& path,
                                                              const LoadOptions& options);

// The same with `text` in place of the file's; other files are still looked for beside `path`.
[[nodiscard]] Result<description::SceneDescription> parse_lab3(const std::string& path,
                                                               std::string_view text,
                                                               const LoadOptions& options);

}  // namespace candela::lab3
