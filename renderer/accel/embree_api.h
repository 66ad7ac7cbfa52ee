// Embree 3.13 and 4 behind one face: the only include of Embree. What differs between them is here
// and nowhere else: the header's folder, the context or arguments of a query.
#pragma once

#if CANDELA_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <limits>

#include "renderer/accel/ray_block.h"
#include "renderer/base/floating_point_traps.h"
#include "renderer/math/ray.h"

namespace candela::embree {

#if CANDELA_EMBREE_MAJOR >= 4
using Context = RTCRayQueryContext;
#else
using Context = RTCIntersectContext;
#endif

// Where rays begin: at t = 0 robust Embree counts hits, of rays from within a face's plane.
inline constexpr float least_t = std::numeric_limits<float>::min();

// What a query carries to the filter functions: Embree hands them a pointer to `context`, which,
// being the first member, is a pointer to the whole.
struct Query {
  Context context;
  const Ray* ray;         // what is asked for, or null:
  const RayBlock* block;  // a block of rays is

  // By ray ID, in the world's space: filters see Embree's ray in that of the instance.
  [[nodiscard]] Ray world_ray(unsigned id) const { return ray ? *ray : (*block)[id]; }
};

inline void initialise(Query& query, const Ray* ray, const RayBlock* block) {
#if CANDELA_EMBREE_MAJOR >= 4
  rtcInitRayQueryContext(&query.context);
#else
  rtcInitIntersectContext(&query.context);
#endif
  query.ray = ray;
  query.block = block;
}

inline void intersect_one(RTCScene scene, RTCRayHit& ray_hit, Query& query) {
  const FloatingPointTraps traps(Traps::Off);
#if CANDELA_EMBREE_MAJOR >= 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &query.context;
  rtcIntersect1(scene, &ray_hit, &arguments);
#else
  rtcIntersect1(scene, &query.context, &ray_hit);
#endif
}

inline void occluded_one(RTCScene scene, RTCRay& ray, Query& query) {
  const FloatingPointTraps traps(Traps::Off);
#if CANDELA_EMBREE_MAJOR >= 4
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &query.context;
  rtcOccluded1(scene, &ray, &arguments);
#else
  rtcOccluded1(scene, &query.context, &ray);
#endif
}

// Packets of sixteen and eight rays. `valid`: -1 in lanes that count, 0 in the others; aligned like
// the rays.
template <std::size_t size>
struct PacketTypes;
template <>
struct PacketTypes<16> {
  using Ray = RTCRay16;
  using RayHit = RTCRayHit16;
  static constexpr auto intersect = rtcIntersect16;
  static constexpr auto occluded = rtcOccluded16;
  static constexpr auto is_native = RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED;
};
template <>
struct PacketTypes<8> {
  using Ray = RTCRay8;
  using RayHit = RTCRayHit8;
  static constexpr auto intersect = rtcIntersect8;
  static constexpr auto occluded = rtcOccluded8;
  static constexpr auto is_native = RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED;
};

// Whether the processor has vectors for such packets. Without, Embree traces the rays of all lanes
// one by one, whether they count or not.
template <std::size_t size>
[[nodiscard]] bool has_packets(RTCDevice device) {
  return rtcGetDeviceProperty(device, PacketTypes<size>::is_native) != 0;
}

template <std::size_t size>
void intersect_packet(RTCScene scene, const int* valid,
                      typename PacketTypes<size>::RayHit& ray_hits, Query& query,
                      Coherence coherence) {
  const FloatingPointTraps traps(Traps::Off);
#if CANDELA_EMBREE_MAJOR >= 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &query.context;
  if (coherence == Coherence::Coherent) arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  PacketTypes<size>::intersect(valid, scene, &ray_hits, &arguments);
#else
  if (coherence == Coherence::Coherent) query.context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  PacketTypes<size>::intersect(valid, scene, &query.context, &ray_hits);
#endif
}

template <std::size_t size>
void occluded_packet(RTCScene scene, const int* valid, typename PacketTypes<size>::Ray& rays,
                     Query& query) {
  const FloatingPointTraps traps(Traps::Off);
#if CANDELA_EMBREE_MAJOR >= 4
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &query.context;
  PacketTypes<size>::occluded(valid, scene, &rays, &arguments);
#else
  PacketTypes<size>::occluded(valid, scene, &query.context, &rays);
#endif
}

}  // namespace candela::embree
