// A scene file -> SceneDescription. The first of the five doors; the format goes by the extension.
#pragma once

#include <string>

#include "renderer/base/result.h"
#include "renderer/description/scene_description.h"
#include "scene_io/load_options.h"

namespace candela {

// All problems at once, as far as recovery goes (errors at most 20). Reads files only; decodes no
// texture.
[[nodiscard]] Result<description::SceneDescription> load(const std::string& path,
                                                         const LoadOptions& options);

}  // namespace candela
