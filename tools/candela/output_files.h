// The files a command is to write, checked before any work.
#pragma once

#include <string>
#include <vector>

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"
#include "tools/candela/exit_code.h"

namespace candela::cli {

// Images by the extension, others (`stats`, may be empty) by folder and permission; no file twice.
struct OutputCheck {
  Diagnostics diagnostics;
  ExitCode exit_code = ExitCode::Done;
};
[[nodiscard]] OutputCheck check_outputs(const std::vector<std::string>& images,
                                        const std::string& stats);

// An error for each output that is one of the files the scene reads.
[[nodiscard]] Diagnostics check_scene_is_spared(const std::vector<std::string>& outputs,
                                                const description::SceneDescription& description);

}  // namespace candela::cli
