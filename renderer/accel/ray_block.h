// Sixteen rays that are asked for together: Embree traces them as one packet.
#pragma once

#include <cstdint>

#include "renderer/geometry/geometry.h"
#include "renderer/math/lanes.h"
#include "renderer/math/ray.h"

namespace candela {

struct RayBlock {
  Vec3Lanes origin, direction;
  Lanes<float> t_max{};

  [[nodiscard]] Ray operator[](std::size_t i) const { return {origin[i], direction[i], t_max[i]}; }
  void set(std::size_t i, const Ray& ray) {
    origin.set(i, ray.origin);
    direction.set(i, ray.direction);
    t_max[i] = ray.t_max;
  }
};

// Hit, by lane.
struct HitBlock {
  HitBlock() {
    t.fill(Hit{}.t);
    geometry.fill(Hit{}.geometry);
    instance.fill(Hit{}.instance);
  }

  Lanes<float> t;
  Lanes<float> u{}, v{};
  Lanes<std::uint32_t> geometry;
  Lanes<std::uint32_t> triangle{};
  Lanes<std::uint32_t> instance;
  // Lanes whose rays met something, and of these what they met is of an instance.
  LaneMask met = 0;
  LaneMask instanced = 0;

  [[nodiscard]] Hit operator[](std::size_t i) const {
    return {t[i], u[i], v[i], geometry[i], triangle[i], instance[i]};
  }
  void set(std::size_t i, const Hit& hit) {
    t[i] = hit.t;
    u[i] = hit.u;
    v[i] = hit.v;
    geometry[i] = hit.geometry;
    triangle[i] = hit.triangle;
    instance[i] = hit.instance;
    const LaneMask others = ~(1u << i);
    met = (met & others) | (hit.is_hit() ? 1u << i : 0);
    instanced = (instanced & others) | (hit.is_hit() && hit.is_instanced() ? 1u << i : 0);
  }
};

// Coherent: rays that go nearly the same way and are best traced side by side to the end.
enum class Coherence : std::uint8_t { Incoherent, Coherent };

// What accelerators without packets do.
template <class A>
[[nodiscard]] HitBlock intersect_one_by_one(const A& accelerator, const RayBlock& rays,
                                            LaneMask lanes) {
  HitBlock hits;
  for_each_lane(lanes, [&](std::uint32_t i) { hits.set(i, accelerator.intersect(rays[i])); });
  return hits;
}
template <class A>
[[nodiscard]] LaneMask occluded_one_by_one(const A& accelerator, const RayBlock& rays,
                                           LaneMask lanes) {
  LaneMask occluded = 0;
  for_each_lane(lanes, [&](std::uint32_t i) {
    if (accelerator.occluded(rays[i])) occluded |= 1u << i;
  });
  return occluded;
}

}  // namespace candela
