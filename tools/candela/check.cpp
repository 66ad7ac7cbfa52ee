// candela check SCENE: a lint
#include <fmt/format.h>

#include "integrators/render.h"
#include "renderer/base/counted.h"
#include "renderer/base/printable.h"
#include "renderer/description/validate.h"
#include "tools/candela/commands.h"
#include "tools/candela/console.h"
#include "tools/candela/decode_textures.h"
#include "tools/candela/read_scene.h"

namespace candela::cli {

ExitCode run_check(const CheckArguments& arguments) {
  Console console(false);
  SceneArguments lenient = arguments.scene;
  lenient.is_strict = false;  // warnings are counted below, after all is looked at
  ReadScene read = read_scene(lenient, console, MemoryNeed::Heeded);
  if (read.is_usable()) {
    decode_all_textures(read.scene->textures);
    Diagnostics found = check_integrator(*read.description, read.options);
    found.append(description::lint(*read.description));
    found.append(read.scene->textures.decoding_diagnostics());
    console.print(found);
    read.error_count += found.error_count();
    read.warning_count += found.warning_count();
  }
  const bool is_refused =
      read.error_count > 0 || (arguments.scene.is_strict && read.warning_count > 0);
  const ExitCode printed = print_result(
      fmt::format("{}: {}, {}\n", printable(arguments.scene.path),
                  counted(read.error_count, "error"), counted(read.warning_count, "warning")),
      console);
  return is_refused ? read.refusal : printed;
}

}  // namespace candela::cli
