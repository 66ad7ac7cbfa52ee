// `Models` and `ComplexModels`: meshes of files, placed in the world.
#pragma once

#include "scene_io/lab3/fields.h"

namespace candela::lab3 {

// Reads the lists, then each mesh file once (several files in parallel), then places them.
// Needs the materials of the file to be there.
void read_models(Reader& reader, const Fields& root);

}  // namespace candela::lab3
