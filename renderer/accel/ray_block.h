// Sixteen rays that are asked for together: Embree traces them as one packet.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "renderer/geometry/geometry.h"
#include "renderer/math/ray.h"

namespace candela {

inline constexpr std::uint32_t block_size = 16;

using RayBlock = std::array<Ray, block_size>;
using HitBlock = std::array<Hit, block_size>;

// Bit i stands for lane i of a block.
using LaneMask = std::uint32_t;
inline constexpr LaneMask all_lanes = (1u << block_size) - 1;

// Coherent: rays that go nearly the same way and are best traced side by side to the end.
enum class Coherence : std::uint8_t { Incoherent, Coherent };

// For each lane of the mask, from the lowest.
// std::popcount, without a call where the processor need not have an instruction for it.
[[nodiscard]] constexpr std::uint32_t lane_count(LaneMask lanes) {
  lanes -= (lanes >> 1) & 0x5555;
  lanes = (lanes & 0x3333) + ((lanes >> 2) & 0x3333);
  lanes = (lanes + (lanes >> 4)) & 0x0f0f;
  return (lanes + (lanes >> 8)) & 0x1f;
}

template <class Visit>
inline void for_each_lane(LaneMask lanes, const Visit& visit) {
  for (; lanes != 0; lanes &= lanes - 1) visit(static_cast<std::uint32_t>(std::countr_zero(lanes)));
}

// What accelerators without packets do.
template <class A>
[[nodiscard]] HitBlock intersect_one_by_one(const A& accelerator, const RayBlock& rays,
                                            LaneMask lanes) {
  HitBlock hits;
  for_each_lane(lanes, [&](std::uint32_t i) { hits[i] = accelerator.intersect(rays[i]); });
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
