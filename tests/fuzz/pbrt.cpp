#include "renderer/description/validate.h"
#include "renderer/scene/compile.h"
#include "scene_io/pbrt/read_pbrt.h"
#include "tests/fuzz/check_errors.h"
#include "tests/fuzz/readers.h"
#include "tests/fuzz/scene_folder.h"

namespace candela::fuzz {

std::string try_pbrt(std::string_view bytes) {
  const auto read = pbrt::parse_pbrt(scene_folder() + "scene.pbrt", std::string(bytes), {});
  if (!read) return fault_of_failure(read.diagnostics);
  const Diagnostics problems = description::validate(*read);
  if (problems.has_errors()) return "validation: " + to_string(problems.list().front());
  const Result<Scene> scene = compile(*read, {.width = 16, .height = 16});
  if (!scene) return "compile: " + to_string(scene.diagnostics.list().front());
  return fault_of(read.diagnostics);
}

}  // namespace candela::fuzz
