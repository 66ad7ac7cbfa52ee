// Which parameters are sure to mean the same.
#pragma once

#include <string>

#include "scene_io/pbrt/parameter.h"

namespace candela::pbrt {

// Two parameters with the same key mean the same. Where they name files it has these files' paths:
// equal names in files of two folders need not mean one file.
[[nodiscard]] std::string key_of(const Parameter& parameter, bool names_files,
                                 const std::string& scene_path);

}  // namespace candela::pbrt
