// The command line over the scene's own wishes over the program's defaults.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "integrators/render_options.h"
#include "renderer/base/result.h"
#include "renderer/description/scene_description.h"
#include "tools/candela/arguments.h"
#include "tools/candela/exit_code.h"

namespace candela::cli {

struct RenderSettings {
  RenderOptions options;
  DisplayTransform display;
  std::vector<std::string> warnings;  // where the scene's wish was not granted to the letter
};

// Whether a picture that does not fit into the memory is refused; it does not matter to who makes
// none.
enum class MemoryNeed : std::uint8_t { Heeded, Ignored };

// Either settings, or one sentence and the code to end with: Usage where the command line asks for
// what the scene does not have, Scene where the scene's own defaults are wrong, Limit where the
// picture is too large.
struct SettledSettings {
  std::optional<RenderSettings> settings;
  std::string error;
  ExitCode exit_code = ExitCode::Done;
};
[[nodiscard]] SettledSettings settle_settings(const RenderArguments& arguments,
                                              const description::SceneDescription& description,
                                              MemoryNeed need = MemoryNeed::Heeded);

// The -o files, or SCENE-stem.exr in the current folder.
[[nodiscard]] std::vector<std::string> output_paths(const RenderArguments& arguments);

}  // namespace candela::cli
