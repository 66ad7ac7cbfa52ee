// `Lights`: point, directional, spot and triangle lights, in the units of light transport.
// lab3 shades kd (n.l) I without 1/pi; a surface of kd/pi looks as bright with pi I
// (docs/scene_format.md, "What lab 3 scenes mean to the path tracer").
#pragma once

#include "scene_io/lab3/fields.h"

namespace candela::lab3 {

void read_lights(Reader& reader, const Fields& root);

}  // namespace candela::lab3
