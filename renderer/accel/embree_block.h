// Blocks of rays in Embree's form, and what it answers: loops over lanes. A packet of eight is one
// half of a block, that which begins at lane `first`.
#pragma once

#include <array>

#include "renderer/accel/embree_api.h"

namespace candela {

// -1 in lanes that count, else 0.
template <std::size_t size>
struct ValidLanes {
  alignas(64) std::array<int, size> lanes;
};

// Sets all of `target` and returns which of it counts.
[[nodiscard]] ValidLanes<16> set_rays(const RayBlock& rays, LaneMask lanes, std::uint32_t first,
                                      RTCRay16& target);
[[nodiscard]] ValidLanes<8> set_rays(const RayBlock& rays, LaneMask lanes, std::uint32_t first,
                                     RTCRay8& target);

// With Embree's IDs. Of rays that met nothing Embree leaves most as it was. Other lanes of `hits`
// than the packet's stay as they are.
void set_hits(const RTCRayHit16& found, std::uint32_t first, HitBlock& hits);
void set_hits(const RTCRayHit8& found, std::uint32_t first, HitBlock& hits);

// Embree marks them by a t_max of -infinity; lanes that did not count may hold anything.
[[nodiscard]] LaneMask occluded_lanes(const RTCRay16& rays, std::uint32_t first);
[[nodiscard]] LaneMask occluded_lanes(const RTCRay8& rays, std::uint32_t first);

}  // namespace candela
