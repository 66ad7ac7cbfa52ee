// Where in its triangles a face is met.
#pragma once

#include <array>
#include <vector>

#include "renderer/accel/face_lanes.h"

namespace candela {

// The triangles of a face: one, or two that share a diagonal.
struct FaceTriangles {
  Vec3f corner{0};  // the face's
  Vec3f across{0};  // above 0 at places on the first one's side of the diagonal
  // Barycentrics of vertices 1 and 2 of the first one, then of the second: at a place relative to
  // the corner they are x, y and z times its parts and what they are at the corner, all four at
  // once.
  alignas(16) std::array<float, 4> x{}, y{}, z{}, at_corner{};
  std::array<std::uint32_t, 2> geometry{}, triangle{};
};

[[nodiscard]] Hit hit_of(const FaceTriangles& triangles, const Ray& ray, float t);

// Of `lanes`, whose rays met a face each. Nothing of the others.
void set_hits(const std::vector<FaceTriangles>& triangles, const RayBlock& rays,
              const FaceLanes& nearest, LaneMask lanes, HitBlock& hits);

}  // namespace candela
