// Visibility of triangles with partial coverage: alpha is the probability of a hit, decided by a
// hash of the ray and the primitive, so that both accelerators, any order of traversal and repeated
// calls for one primitive agree.
#pragma once

#include "renderer/geometry/geometry.h"
#include "renderer/scene/scene.h"

namespace candela {

// Whether the ray passes through `triangle` of `geometry` at the barycentrics (u, v).
// `instance`: as in Hit. Ray in world space, as given to the accelerator.
[[nodiscard]] bool is_transparent_at(const Scene& scene, std::uint32_t geometry,
                                     std::uint32_t triangle, std::uint32_t instance, float u,
                                     float v, const Vec3f& ray_origin, const Vec3f& ray_direction);

}  // namespace candela
