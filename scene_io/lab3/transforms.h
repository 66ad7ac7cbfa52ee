// Translation, Scale and Rotation of a model or of one of its instances.
#pragma once

#include "renderer/math/transform.h"
#include "scene_io/lab3/fields.h"

namespace candela::lab3 {

inline constexpr std::string_view transform_keys[] = {"Translation", "Scale", "Rotation"};

// p' = T + R (S p), the written intent. (The framework's code computes T + (R s) (.) p, by the
// grouping of its operators; the two agree for R = 1, which all of its scenes have.)
// (docs/scene_format.md, "Models".) A singular map is an error and gives the identity.
[[nodiscard]] Transform read_transform(Reader& reader, const Fields& fields);

}  // namespace candela::lab3
