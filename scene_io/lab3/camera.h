// `Cameras`: lab3's pinhole, and the extension's thin lens.
#pragma once

#include "scene_io/lab3/fields.h"

namespace candela::lab3 {

// Every camera of the file; sets Reader::z_far from the first.
void read_cameras(Reader& reader, const Fields& root);

}  // namespace candela::lab3
