// lab3's own material: Blinn-Phong, with all the traps of its keys
// (docs/scene_format.md, "Materials").
#pragma once

#include "scene_io/lab3/fields.h"

namespace candela::lab3 {

[[nodiscard]] description::LabMaterial read_lab_material(Reader& reader, const Fields& fields);

}  // namespace candela::lab3
