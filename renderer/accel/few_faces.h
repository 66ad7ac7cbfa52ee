// What of a scene is looked at face by face and sphere by sphere, and what by a tree: all of a
// scene of few, or the walls of a room with a few dense things in it.
#pragma once

#include <vector>

#include "renderer/accel/box_list.h"
#include "renderer/accel/face_list.h"
#include "renderer/accel/sphere_list.h"

namespace candela {

struct FewFaces {
  FaceList faces;
  SphereList spheres;
  BoxList boxes;  // around the rest
  std::vector<GeometryHandle> rest;
};

// Whether a list of faces and spheres with a tree for the rest takes less time than a tree of
// everything, where such a share of rays enters a box of the rest (docs/decisions.md).
[[nodiscard]] constexpr bool pays(std::size_t listed, double entering) {
  return entering + static_cast<double>(listed) / 200 < 0.45;
}

// Nothing where the scene has instances or too many faces for either.
[[nodiscard]] FewFaces find_few_faces(const Scene& scene);

}  // namespace candela
