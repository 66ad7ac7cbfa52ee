#include "renderer/accel/embree_block.h"

#include <cmath>
#include <cstring>

#include "renderer/base/vector_widths.h"

namespace candela {
namespace {

// Stored as one vector, as which Embree reads it: for narrower stores it would have to wait.
template <std::size_t size>
inline void copy_lanes(const Lanes<float>& from, std::uint32_t first, float (&to)[size]) {
  using Vector [[gnu::vector_size(sizeof(to))]] = float;
  Vector lanes;
  std::memcpy(&lanes, from.data() + first, sizeof(lanes));
  std::memcpy(to, &lanes, sizeof(lanes));
}
template <class T, std::size_t size>
inline void fill_lanes(T value, T (&to)[size]) {
  using Vector [[gnu::vector_size(sizeof(to))]] = T;
  const Vector lanes = Vector{} + value;
  std::memcpy(to, &lanes, sizeof(lanes));
}

template <std::size_t size, class Packet>
inline ValidLanes<size> set_packet(const RayBlock& rays, LaneMask lanes, std::uint32_t first,
                                   Packet& target) {
  copy_lanes(rays.origin.x, first, target.org_x);
  copy_lanes(rays.origin.y, first, target.org_y);
  copy_lanes(rays.origin.z, first, target.org_z);
  copy_lanes(rays.direction.x, first, target.dir_x);
  copy_lanes(rays.direction.y, first, target.dir_y);
  copy_lanes(rays.direction.z, first, target.dir_z);
  copy_lanes(rays.t_max, first, target.tfar);
  fill_lanes(embree::least_t, target.tnear);
  fill_lanes(0.0f, target.time);
  fill_lanes(RTC_INVALID_GEOMETRY_ID, target.mask);
  fill_lanes(0u, target.flags);
  ValidLanes<size> valid;
  for (std::uint32_t i = 0; i < size; ++i) {
    valid.lanes[i] = -static_cast<int>(lanes >> (first + i) & 1);
    target.id[i] = first + i;
  }
  return valid;
}

template <std::size_t size, class Packet>
inline void set_hits_of(const Packet& found, std::uint32_t first, HitBlock& hits) {
  LaneFlags met{}, instanced{};
  for (std::uint32_t i = 0; i < size; ++i) {
    const bool is_hit = found.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
    met[i] = is_hit ? 1 : 0;
    instanced[i] = found.hit.instID[0][i] != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
    hits.t[first + i] = is_hit ? found.ray.tfar[i] : infinity;
    hits.u[first + i] = is_hit ? found.hit.u[i] : 0;
    hits.v[first + i] = is_hit ? found.hit.v[i] : 0;
    hits.geometry[first + i] = found.hit.geomID[i];
    hits.triangle[first + i] = is_hit ? found.hit.primID[i] : 0;
    hits.instance[first + i] = found.hit.instID[0][i];
  }
  const LaneMask packet = ((1u << size) - 1) << first;
  hits.met = (hits.met & ~packet) | mask_of(met) << first;
  hits.instanced = (hits.instanced & ~packet) | ((mask_of(instanced) << first) & hits.met);
}

template <std::size_t size, class Packet>
inline LaneMask occluded_of(const Packet& rays, std::uint32_t first) {
  LaneFlags flags{};
  for (std::uint32_t i = 0; i < size; ++i) flags[i] = std::signbit(rays.tfar[i]) ? 1 : 0;
  return mask_of(flags) << first;
}

}  // namespace

CANDELA_LANES ValidLanes<16> set_rays(const RayBlock& rays, LaneMask lanes, std::uint32_t first,
                                      RTCRay16& target) {
  return set_packet<16>(rays, lanes, first, target);
}
CANDELA_LANES ValidLanes<8> set_rays(const RayBlock& rays, LaneMask lanes, std::uint32_t first,
                                     RTCRay8& target) {
  return set_packet<8>(rays, lanes, first, target);
}

CANDELA_LANES void set_hits(const RTCRayHit16& found, std::uint32_t first, HitBlock& hits) {
  set_hits_of<16>(found, first, hits);
}
CANDELA_LANES void set_hits(const RTCRayHit8& found, std::uint32_t first, HitBlock& hits) {
  set_hits_of<8>(found, first, hits);
}

CANDELA_LANES LaneMask occluded_lanes(const RTCRay16& rays, std::uint32_t first) {
  return occluded_of<16>(rays, first);
}
CANDELA_LANES LaneMask occluded_lanes(const RTCRay8& rays, std::uint32_t first) {
  return occluded_of<8>(rays, first);
}

}  // namespace candela
