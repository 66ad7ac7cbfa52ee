// Load and compile with messages: what info, check, convert and bench begin with.
#pragma once

#include <optional>

#include "renderer/description/scene_description.h"
#include "renderer/scene/scene.h"
#include "tools/candela/arguments.h"
#include "tools/candela/console.h"
#include "tools/candela/exit_code.h"
#include "tools/candela/render_settings.h"

namespace candela::cli {

// Empty where the scene has errors (or, with --strict, warnings); they are printed. With `need`
// heeded a picture that does not fit into the memory is an error, too.
struct ReadScene {
  std::optional<description::SceneDescription> description;
  std::optional<Scene> scene;
  RenderOptions options;  // as the scene itself asks to be rendered
  std::size_t error_count = 0;
  std::size_t warning_count = 0;
  ExitCode refusal = ExitCode::Scene;  // how it ends where it has errors
  [[nodiscard]] bool is_usable() const { return scene.has_value(); }
};
[[nodiscard]] ReadScene read_scene(const SceneArguments& arguments, Console& console,
                                   MemoryNeed need = MemoryNeed::Ignored);

// As the scene itself asks to be rendered.
[[nodiscard]] RenderArguments as_the_scene_asks(const SceneArguments& arguments);

}  // namespace candela::cli
