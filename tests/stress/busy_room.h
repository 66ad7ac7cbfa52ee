// The scene that most disturbances are tried on: one of each kind that compile() and the kernels
// treat apart.
#pragma once

#include "tests/scenes/description.h"

namespace candela::test {

// small_room() with a rough metal and a glass sphere (one mesh, instances of it), a point light, a
// spot light, a sun and a sky, seen through a lens. Every number is carried by 32 bits.
[[nodiscard]] description::SceneDescription busy_room();

}  // namespace candela::test
