// The concept that integrators trace rays with, and the one choke point before it.
#pragma once

#include <concepts>
#include <cstddef>

#include "renderer/geometry/geometry.h"
#include "renderer/math/float4.h"
#include "renderer/math/ray.h"

namespace candela {

// intersect: the nearest hit with 0 < t < ray.t_max, cut-outs seen through. occluded: whether there
// is any. Both are pure and thread-safe. Whether a triangle is hit in whose plane the ray starts or
// ends exactly is left open (Embree answers t = 0 then): offset the origin first.
template <class A>
concept Accelerator = requires(const A& accelerator, const Ray& ray) {
  { accelerator.intersect(ray) } -> std::same_as<Hit>;
  { accelerator.occluded(ray) } -> std::same_as<bool>;
  { accelerator.memory_bytes() } -> std::same_as<std::size_t>;
};

// Debian's Embree is built with asserts: a NaN, a component near 1e19 or a negative range would
// abort the process. Every ray passes here first; a ray that fails is counted as invalid.
[[nodiscard]] inline bool is_traceable(const Ray& ray) {
  const Float4 origin = absolute(to_lanes(ray.origin));
  const Float4 direction = absolute(to_lanes(ray.direction));
  const Float4 limit = broadcast(1e15f);
  const int bounded = mask_of((origin < limit) & (direction < limit));
  const int nonzero = mask_of(direction > broadcast(0.0f));
  return bounded == 0xf && nonzero != 0 && ray.t_max > 0;
}

}  // namespace candela
