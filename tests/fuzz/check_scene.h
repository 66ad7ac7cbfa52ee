// What a reader of scenes must keep: what it accepts is valid and compiles (but for cameras further
// away than floats tell, which compiling finds), what it does not is told.
#pragma once

#include <string>

#include "renderer/description/validate.h"
#include "renderer/scene/compile.h"
#include "tests/fuzz/check_errors.h"

namespace candela::fuzz {

inline bool is_of_a_far_camera(const Diagnostics& diagnostics) {
  return diagnostics.list().back().message.find(" times the scene's size") != std::string::npos;
}

inline std::string fault_of_scene(const Result<description::SceneDescription>& read) {
  if (!read) return fault_of_failure(read.diagnostics);
  const Diagnostics problems = description::validate(*read);
  if (problems.has_errors()) return "validation: " + to_string(problems.list().front());
  const Result<Scene> scene = compile(*read, {.width = 16, .height = 16});
  if (!scene && !is_of_a_far_camera(scene.diagnostics))
    return "compile: " + to_string(scene.diagnostics.list().front());
  return fault_of(read.diagnostics);
}

}  // namespace candela::fuzz
