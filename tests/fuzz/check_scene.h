// What a reader of scenes must keep: what it accepts is valid and compiles, what it does not is
// told. Only compiling finds cameras further away than floats tell and images of lights that are
// broken or too dark.
#pragma once

#include <string>

#include "renderer/description/validate.h"
#include "renderer/scene/compile.h"
#include "tests/fuzz/check_errors.h"

namespace candela::fuzz {

inline bool is_found_by_compiling(const Diagnostic& error) {
  return error.message.find(" times the scene's size") != std::string::npos ||
         error.message.find(" times the mean of its image") != std::string::npos ||
         error.message.starts_with("a light's image ");
}

inline std::string fault_of_scene(const Result<description::SceneDescription>& read) {
  if (!read) return fault_of_failure(read.diagnostics);
  const Diagnostics problems = description::validate(*read);
  if (problems.has_errors()) return "validation: " + to_string(problems.list().front());
  const Result<Scene> scene = compile(*read, {.width = 16, .height = 16});
  for (const Diagnostic& found : scene.diagnostics.list())
    if (found.severity == Severity::Error && !is_found_by_compiling(found))
      return "compile: " + to_string(found);
  return fault_of(read.diagnostics);
}

}  // namespace candela::fuzz
