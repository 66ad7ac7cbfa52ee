// A mirror in the small room.
#pragma once

#include "tests/scenes/description.h"
#include "tests/scenes/meshes.h"

namespace candela::test {

inline void add_leaning_mirror(description::SceneDescription& scene) {
  add_mesh(scene, quad({-0.9, -0.9, 0.3}, {0.6, 0, 0.3}, {0, 0.8, 0}),
           add_material(scene, description::MirrorMaterial{}));
}

}  // namespace candela::test
