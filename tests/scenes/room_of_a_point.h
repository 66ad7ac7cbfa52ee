// A room whose direct light has no noise: what bounces has all.
#pragma once

#include "tests/scenes/description.h"

namespace candela::test {

// A closed box of diffuse walls around a point light, seen from its middle.
[[nodiscard]] inline description::SceneDescription room_of_a_point(double albedo) {
  description::SceneDescription scene =
      furnace(inside_out(box({-1, -1, -1}, {1, 1, 1})), albedo, 0);
  add_light(scene, description::PointLight{{0.3, 0.4, 0.2}, Vec3d(1)});
  return scene;
}

}  // namespace candela::test
