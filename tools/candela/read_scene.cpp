#include "tools/candela/read_scene.h"

#include "renderer/scene/compile.h"
#include "scene_io/load.h"

namespace candela::cli {
namespace {

void report(const Diagnostics& diagnostics, Console& console, ReadScene& read) {
  console.print(diagnostics);
  read.error_count += diagnostics.error_count();
  read.warning_count += diagnostics.warning_count();
}

}  // namespace

RenderArguments as_the_scene_asks(const SceneArguments& arguments) {
  RenderArguments render;
  render.scene = arguments;
  return render;
}

ReadScene read_scene(const SceneArguments& arguments, Console& console, MemoryNeed need) {
  ReadScene read;
  auto description = load(arguments.path, arguments.load);
  report(description.diagnostics, console, read);
  if (!description) return read;
  const SettledSettings settled = settle_settings(as_the_scene_asks(arguments), *description, need);
  if (!settled.settings) {
    console.error(settled.error);
    ++read.error_count;
  } else {
    for (const std::string& sentence : settled.settings->warnings) console.warning(sentence);
    read.warning_count += settled.settings->warnings.size();
    read.options = settled.settings->options;
  }
  auto scene =
      compile(*description, settled.settings ? compile_options(read.options) : CompileOptions{});
  report(scene.diagnostics, console, read);
  const bool is_all = read.error_count == 1;  // the scene has no error of its own
  if (!settled.settings && is_all) read.refusal = settled.exit_code;
  if (read.error_count > 0) return read;
  if (arguments.is_strict && read.warning_count > 0) {
    console.strict_error(read.warning_count, arguments.path);
    return read;
  }
  read.description = std::move(description.value);
  read.scene = std::move(scene.value);
  return read;
}

}  // namespace candela::cli
