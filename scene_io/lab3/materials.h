// `Materials`: lab3's own (no Type) and the extension's (with a Type).
#pragma once

#include "scene_io/lab3/fields.h"

namespace candela::lab3 {

// Every material of the file, in its order; fills Reader::materials_by_name (of equal names the
// last counts, as in lab3).
void read_materials(Reader& reader, const Fields& root);

}  // namespace candela::lab3
