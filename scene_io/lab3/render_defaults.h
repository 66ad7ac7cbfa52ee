// `Render`: what the scene asks for where the command line says nothing.
#pragma once

#include "scene_io/lab3/fields.h"

namespace candela::lab3 {

void read_render_defaults(Reader& reader, const Fields& root);

}  // namespace candela::lab3
