// The directives of a pbrt file and of the files it includes -> Program.
#pragma once

#include "scene_io/pbrt/program.h"
#include "scene_io/pbrt/source_files.h"

namespace candela::pbrt {

// All errors at once, as far as recovery goes: after one it goes on at the next directive. `files`
// has the first file open and keeps all texts that the program's places point into.
[[nodiscard]] Program parse(SourceFiles& files, const Report& report);

}  // namespace candela::pbrt
