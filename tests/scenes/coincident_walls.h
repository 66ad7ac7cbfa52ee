// Surfaces in the very same place.
#pragma once

#include <utility>

#include "tests/scenes/description.h"

namespace candela::test {

// The small room with walls of two colours: which of the two a ray of a packet meets may depend on
// the other rays in it.
[[nodiscard]] inline description::SceneDescription walls_of_two_colours() {
  description::SceneDescription scene = small_room();
  const std::size_t count = scene.meshes.size();
  for (std::size_t m = 0; m < count; ++m) {
    description::Mesh mesh = scene.meshes[m];
    if (scene.materials[mesh.materials.at(0).index].emission != Vec3d(0.0)) continue;
    std::swap(mesh.triangles.front(), mesh.triangles.back());
    add_mesh(scene, mesh, add_material(scene, description::DiffuseMaterial{{Vec3d(0.1), {}}}));
  }
  return scene;
}

}  // namespace candela::test
