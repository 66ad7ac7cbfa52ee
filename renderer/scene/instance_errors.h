// What rounding does to the surfaces of instances.
#pragma once

#include "renderer/geometry/geometry.h"
#include "renderer/math/bounds.h"

namespace candela {

// Fills placing_error and ray_error, for rays that start on the instance. `object`: the bounds of
// what is placed.
void set_errors(Instance& instance, const Bounds3f& object);

}  // namespace candela
