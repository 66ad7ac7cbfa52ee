// What a reader of scenes must keep: what it accepts is valid and compiles, what it does not is
// told. Cameras further away than floats tell and broken images of lights only compiling finds.
#pragma once

#include <string>

#include "renderer/description/validate.h"
#include "renderer/scene/compile.h"
#include "tests/fuzz/check_errors.h"

namespace candela::fuzz {

inline bool is_found_by_compiling(const Diagnostics& diagnostics) {
  const std::string& message = diagnostics.list().back().message;
  return message.find(" times the scene's size") != std::string::npos ||
         message.starts_with("a light's image ");
}

inline std::string fault_of_scene(const Result<description::SceneDescription>& read) {
  if (!read) return fault_of_failure(read.diagnostics);
  const Diagnostics problems = description::validate(*read);
  if (problems.has_errors()) return "validation: " + to_string(problems.list().front());
  const Result<Scene> scene = compile(*read, {.width = 16, .height = 16});
  if (!scene && !is_found_by_compiling(scene.diagnostics))
    return "compile: " + to_string(scene.diagnostics.list().front());
  return fault_of(read.diagnostics);
}

}  // namespace candela::fuzz
