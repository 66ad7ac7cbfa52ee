// The ground planes that the course's program, and no file, adds to two scenes
// (--lab3-ground IMAGE; docs/scene_format.md, "Ground planes that are in no file").
#pragma once

#include "scene_io/lab3/reader.h"

namespace candela::lab3 {

// A square of side ZFar about the origin, its picture repeated 30 times: at y = -10 for a file
// named white_oak, else at the lowest y of the models. Nothing without the option.
void add_ground(Reader& reader);

}  // namespace candela::lab3
