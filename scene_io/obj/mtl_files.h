// The MTL files that an OBJ file names.
#pragma once

#include <string>

#include "scene_io/obj/obj_data.h"
#include "scene_io/obj/read_obj.h"

namespace candela::obj {

// Reads each once, in the order of the file, and adds its materials, images and path to the model.
// A line may name one file with spaces in its name or several. Missing ones get a warning; whether
// there are none.
bool read_libraries(const std::string& path, const text::Source& source, const ObjData& data,
                    MtlUse use, ObjModel& model, Diagnostics& diagnostics);

}  // namespace candela::obj
