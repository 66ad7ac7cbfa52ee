// Blocks of rays in Embree's form, and what it answers: loops over lanes.
#pragma once

#include <array>

#include "renderer/accel/embree_api.h"

namespace candela {

// -1 in lanes that count, else 0.
struct ValidLanes {
  alignas(64) std::array<int, block_size> lanes;
};

// Sets all of `target` and returns which of it counts.
[[nodiscard]] ValidLanes set_rays(const RayBlock& rays, LaneMask lanes, RTCRay16& target);

// With Embree's IDs. Of rays that met nothing Embree leaves most as it was.
void set_hits(const RTCRayHit16& found, HitBlock& hits);

// Embree marks them by a t_max of -infinity; lanes that did not count may hold anything.
[[nodiscard]] LaneMask occluded_lanes(const RTCRay16& rays);

}  // namespace candela
