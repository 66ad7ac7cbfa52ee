#include "renderer/accel/embree_block.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/vector_widths.h"

namespace candela {
namespace {

template <std::size_t size>
void copy_lanes(const Lanes<float>& from, float (&to)[size]) {
  static_assert(size == block_size);
  std::copy(from.begin(), from.end(), to);
}

}  // namespace

CANDELA_LANES ValidLanes set_rays(const RayBlock& rays, LaneMask lanes, RTCRay16& target) {
  copy_lanes(rays.origin.x, target.org_x);
  copy_lanes(rays.origin.y, target.org_y);
  copy_lanes(rays.origin.z, target.org_z);
  copy_lanes(rays.direction.x, target.dir_x);
  copy_lanes(rays.direction.y, target.dir_y);
  copy_lanes(rays.direction.z, target.dir_z);
  copy_lanes(rays.t_max, target.tfar);
  ValidLanes valid;
  for (std::uint32_t i = 0; i < block_size; ++i) {
    valid.lanes[i] = -static_cast<int>(lanes >> i & 1);
    target.id[i] = i;
    target.tnear[i] = 0;
    target.time[i] = 0;
    target.mask[i] = RTC_INVALID_GEOMETRY_ID;
    target.flags[i] = 0;
  }
  return valid;
}

CANDELA_LANES void set_hits(const RTCRayHit16& found, HitBlock& hits) {
  LaneFlags met, instanced;
  for (std::uint32_t i = 0; i < block_size; ++i) {
    const bool is_hit = found.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
    met[i] = is_hit ? 1 : 0;
    instanced[i] = found.hit.instID[0][i] != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
    hits.t[i] = is_hit ? found.ray.tfar[i] : infinity;
    hits.u[i] = is_hit ? found.hit.u[i] : 0;
    hits.v[i] = is_hit ? found.hit.v[i] : 0;
    hits.geometry[i] = found.hit.geomID[i];
    hits.triangle[i] = is_hit ? found.hit.primID[i] : 0;
    hits.instance[i] = found.hit.instID[0][i];
  }
  hits.met = mask_of(met);
  hits.instanced = mask_of(instanced) & hits.met;
}

CANDELA_LANES LaneMask occluded_lanes(const RTCRay16& rays) {
  LaneFlags flags;
  for (std::uint32_t i = 0; i < block_size; ++i) flags[i] = std::signbit(rays.tfar[i]) ? 1 : 0;
  return mask_of(flags);
}

}  // namespace candela
