// The media on both sides of a surface that a path met. Nothing at all in kernels without media.
#pragma once

#include <type_traits>

#include "integrators/path/feature_set.h"
#include "renderer/geometry/surface_point.h"
#include "renderer/medium/medium.h"

namespace candela {

struct NoMedia {};

// `near` is on the side that the path came from.
struct NearAndFarMedium {
  MediumHandle near;
  MediumHandle far;
};

template <FeatureSet F>
using MediaBeside = std::conditional_t<F.media, NearAndFarMedium, NoMedia>;

// Where the boundary has nothing to say, the surface is within what the path was in.
[[nodiscard]] inline NearAndFarMedium media_beside(const MediumBoundary& boundary, bool is_front,
                                                   MediumHandle current) {
  if (!boundary.is_transition()) return {current, current};
  if (is_front) return {boundary.outside, boundary.inside};
  return {boundary.inside, boundary.outside};
}

// What light that leaves the surface towards `wi` is in.
[[nodiscard]] inline MediumHandle medium_towards(NearAndFarMedium media, const SurfacePoint& point,
                                                 const Vec3f& wi) {
  return dot(wi, point.geometric_normal) > 0 ? media.near : media.far;
}

}  // namespace candela
