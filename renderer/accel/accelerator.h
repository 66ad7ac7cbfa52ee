// The concept that integrators trace rays with, and the one choke point before it.
#pragma once

#include <concepts>
#include <cstddef>

#include "renderer/accel/ray_block.h"
#include "renderer/geometry/geometry.h"
#include "renderer/math/ray.h"

namespace candela {

// intersect: the nearest hit with 0 < t < ray.t_max, cut-outs seen through. occluded: whether there
// is any. Both are pure and thread-safe, as are their forms for the given lanes of a block of rays,
// whose answers are those of single rays (of hits at the very same distance any may be told).
// Whether a surface is hit on which the ray starts or ends exactly is left open (Embree then
// answers t = 0): offset the origin first.
template <class A>
concept Accelerator = requires(const A& accelerator, const Ray& ray, const RayBlock& rays,
                               LaneMask lanes, Coherence coherence) {
  { accelerator.intersect(ray) } -> std::same_as<Hit>;
  { accelerator.occluded(ray) } -> std::same_as<bool>;
  { accelerator.intersect(rays, lanes, coherence) } -> std::same_as<HitBlock>;
  { accelerator.occluded(rays, lanes) } -> std::same_as<LaneMask>;
  { accelerator.memory_bytes() } -> std::same_as<std::size_t>;
};

// Debian's Embree is built with asserts: a NaN, a component near 1e19 or a negative range would
// abort the process. Every ray passes here first. A path whose ray fails is counted as invalid; a
// shadow ray that does brings nothing.
[[nodiscard]] inline bool is_traceable(const Ray& ray) {
  const float direction = sum_of_absolutes(ray.direction);
  return direction > 0 && direction + sum_of_absolutes(ray.origin) < farthest_traceable &&
         ray.t_max > 0;
}

}  // namespace candela
