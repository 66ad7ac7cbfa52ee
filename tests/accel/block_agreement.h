// Rays in blocks, against what the same rays are told alone.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "renderer/accel/accelerator.h"

namespace candela::test {

[[nodiscard]] inline bool are_equal(const Hit& a, const Hit& b) {
  return a.t == b.t && a.u == b.u && a.v == b.v && a.geometry == b.geometry &&
         a.triangle == b.triangle;
}

// Calls visit(block, lanes) for blocks of rays from all over the set, the lanes taking turns among
// `masks`.
template <class Visit>
void for_each_mixed_block(const std::vector<Ray>& rays, const std::vector<LaneMask>& masks,
                          const Visit& visit) {
  for (std::size_t first = 0; first + block_size <= rays.size(); first += block_size) {
    RayBlock block;
    for (std::size_t i = 0; i < block_size; ++i)
      block.set(i, rays[(first + i * 251) % rays.size()]);
    visit(block, masks[first / block_size % masks.size()]);
  }
}

// In any lane and beside any others a ray is told the same. Returns how many met something.
template <class A>
std::size_t expect_blocks_told_as_rays(const A& accelerator, const std::vector<Ray>& rays,
                                       const std::vector<LaneMask>& masks,
                                       const std::string& name) {
  std::size_t hits = 0;
  for_each_mixed_block(rays, masks, [&](const RayBlock& block, LaneMask lanes) {
    const HitBlock found = accelerator.intersect(block, lanes, Coherence::Incoherent);
    const LaneMask occluded = accelerator.occluded(block, lanes);
    EXPECT_EQ((found.met | occluded) & ~lanes, 0u) << name;
    for_each_lane(lanes, [&](std::uint32_t i) {
      const Hit single = accelerator.intersect(block[i]);
      hits += single.is_hit();
      ASSERT_TRUE(are_equal(found[i], single)) << name;
      ASSERT_EQ((occluded >> i & 1) != 0, accelerator.occluded(block[i])) << name;
    });
  });
  return hits;
}

}  // namespace candela::test
