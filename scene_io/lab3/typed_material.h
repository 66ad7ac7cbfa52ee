// The extension's materials: linear colours, maps that replace factors.
#pragma once

#include "scene_io/lab3/fields.h"
#include "scene_io/lab3/material_keys.h"

namespace candela::lab3 {

// `type` must not be Lab.
[[nodiscard]] decltype(description::Material::model) read_typed_material(Reader& reader,
                                                                         const Fields& fields,
                                                                         MaterialType type);

}  // namespace candela::lab3
