// Spheres that are no meshes of triangles, and where to put them.
#pragma once

#include "renderer/description/scene_description.h"

namespace candela::test {

// About the origin.
[[nodiscard]] inline description::Mesh exact_sphere(double radius, bool faces_inwards = false) {
  description::Mesh mesh;
  mesh.name = "sphere";
  mesh.sphere = description::Sphere{radius, faces_inwards};
  return mesh;
}

[[nodiscard]] inline Transform at_place(const Vec3d& place, double scale = 1) {
  return {Mat3d(scale), place};
}

}  // namespace candela::test
