// The files a command is to write, checked before any work.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"
#include "tools/candela/exit_code.h"

namespace candela::cli {

// Images by the extension, `stats` by folder and permission; no file twice.
struct OutputCheck {
  Diagnostics diagnostics;
  ExitCode exit_code = ExitCode::Done;
};
[[nodiscard]] OutputCheck check_outputs(const std::vector<std::string>& images,
                                        const std::optional<std::string>& stats);

// An error for each image that is of a format without room for so many pixels a side.
[[nodiscard]] Diagnostics check_image_sizes(const std::vector<std::string>& images, int width,
                                            int height);

// An error for each output that is one of `inputs`, which `reader` reads.
[[nodiscard]] Diagnostics check_inputs_are_spared(const std::vector<std::string>& outputs,
                                                  const std::vector<std::string>& inputs,
                                                  std::string_view reader);
// The same of the files that the scene reads.
[[nodiscard]] Diagnostics check_scene_is_spared(const std::vector<std::string>& outputs,
                                                const description::SceneDescription& description);

}  // namespace candela::cli
