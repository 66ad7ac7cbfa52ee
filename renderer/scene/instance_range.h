// Which instances rays can be brought to in floats.
#pragma once

#include <cstddef>
#include <span>

#include "renderer/scene/scene.h"

namespace candela {

// Whether both accelerators take the instance in. `object`: the bounds of what is placed.
[[nodiscard]] bool is_placeable(const Instance& instance, const Bounds3f& object);

// Whether a placement of few triangles is so large that they had better be cut (split_triangles.h),
// which only the world's are.
[[nodiscard]] bool is_large_ground(const Instance& instance, const Bounds3f& object,
                                   std::size_t triangles);

// How far from the scene's centre a ray may start for its numbers to stay within Embree's when it
// is moved into the space of the instance's object. `instance` is placeable.
[[nodiscard]] double farthest_origin(const Instance& instance);

// How far from the scene's centre rays start. `world`: the bounds of what is no instance.
[[nodiscard]] double reach_of_rays(const Scene& scene, const Bounds3f& world,
                                   std::span<const Bounds3f> objects);

}  // namespace candela
