#include "scene_io/pbrt/read_pbrt.h"

#include <fmt/format.h>

#include "scene_io/pbrt/build_scene.h"
#include "scene_io/pbrt/parse.h"
#include "scene_io/text/file.h"
#include "scene_io/text/plain_text.h"

namespace candela::pbrt {
Result<description::SceneDescription> read_pbrt(const std::string& path) {
  Result<std::string> bytes = text::read_file(path);
  if (!bytes) return std::move(bytes.diagnostics);
  return parse_pbrt(path, std::move(*bytes));
}

Result<description::SceneDescription> parse_pbrt(const std::string& path, std::string text) {
  Diagnostics diagnostics;
  const Report report(diagnostics);
  description::SceneDescription scene;
  scene.path = path;
  if (text::is_utf16(text))
    return failure(fmt::format("{} is in UTF-16, expected UTF-8", text::quoted_path(path)));
  text::drop_byte_order_mark(text);
  SourceFiles files(scene.path, report);
  files.open(path, std::move(text));
  Program program = parse(files, report);
  // What was misread would only bring more errors, but other faults are worth to be known.
  if (diagnostics.has_errors()) return diagnostics;
  scene.files = program.files;
  Context context{program, scene, report};
  build_scene(context);
  if (diagnostics.has_errors()) return diagnostics;
  return {std::move(scene), std::move(diagnostics)};
}

}  // namespace candela::pbrt
