// What the two halves of Embree's accelerator share: how it is built (embree_build.cpp) and what it
// is asked (embree_accel.cpp).
#pragma once

#include <array>
#include <atomic>
#include <limits>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "renderer/accel/embree_accel.h"
#include "renderer/accel/embree_api.h"
#include "renderer/accel/embree_spheres.h"
#include "renderer/accel/few_faces.h"
#include "renderer/base/handover.h"

namespace candela {
namespace embree {

struct ReleaseDevice {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct ReleaseGeometry {
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseDevice>;
using EmbreeScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene>;
using EmbreeGeometry = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, ReleaseGeometry>;

inline constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
static_assert(none == RTC_INVALID_GEOMETRY_ID);
static_assert(RTC_MAX_INSTANCE_LEVEL_COUNT == 1);

}  // namespace embree

// Of how many rays Embree's packets are, and how many of them must count at least for a packet to
// take less time than its rays one by one (docs/decisions.md, "From how many rays on a packet
// pays").
struct PacketRules {
  std::uint32_t size;
  std::uint32_t fewest_coherent, fewest_incoherent, fewest_shadow;
};
inline constexpr PacketRules no_packets{block_size, block_size + 1, block_size + 1, block_size + 1};
[[nodiscard]] PacketRules packet_rules_of(RTCDevice device);

struct EmbreeAccel::State {
  const Scene* scene = nullptr;
  EmbreeOptions options;
  Handover callbacks;  // Embree calls back from threads of its own
  std::atomic<std::size_t> bytes{0};
  std::mutex error_mutex;
  RTCError error = RTC_ERROR_NONE;
  std::array<char, 256> error_text{};     // of the first; no string: memory may be what lacks
  std::vector<EmbreeUserData> user_data;  // by geometry
  // Released in reverse order, and Embree reports every release to `bytes`.
  embree::Device device;
  std::vector<embree::EmbreeScene> objects;
  embree::EmbreeScene world;
  embree::EmbreeScene rest;  // what no list of faces has; null where there is nothing, or no list
  FewFaces few;
  PacketRules packets{};

  State(const Scene& s, EmbreeOptions o) : scene(&s), options(o) {
    if (o.faces) few = find_few_faces(s);
  }

  void open_device();
  void build();
  [[nodiscard]] RTCBuildQuality quality() const;
  [[nodiscard]] embree::EmbreeScene new_scene() const;
  // Of geometries of the world, which keep their index as ID.
  [[nodiscard]] embree::EmbreeScene scene_of(std::span<const GeometryHandle> geometries);
  // Of rays that go where paths do those that enter a box of the rest.
  [[nodiscard]] double share_of_entering_rays() const;
  [[nodiscard]] embree::EmbreeGeometry triangles_of(std::uint32_t index);
  void attach_geometry(RTCScene target, std::uint32_t index, std::uint32_t id);
  void attach_instance(std::size_t index);
  void build_object(std::size_t index);
  void throw_if_failed();

  // By Embree itself.
  [[nodiscard]] Hit intersect(RTCScene in, const Ray& ray) const;
  [[nodiscard]] bool occluded(RTCScene in, const Ray& ray) const;
  [[nodiscard]] HitBlock intersect(RTCScene in, const RayBlock& rays, LaneMask lanes,
                                   Coherence coherence) const;
  [[nodiscard]] LaneMask occluded(RTCScene in, const RayBlock& rays, LaneMask lanes) const;
  // Of the packet of a block that begins at lane `first`.
  template <std::size_t size>
  void intersect_packet(RTCScene in, const RayBlock& rays, LaneMask lanes, std::uint32_t first,
                        Coherence coherence, HitBlock& hits) const;
  template <std::size_t size>
  [[nodiscard]] LaneMask occluded_packet(RTCScene in, const RayBlock& rays, LaneMask lanes,
                                         std::uint32_t first) const;

  // By the list of faces, where there is one.
  [[nodiscard]] Hit nearest(const Ray& ray) const;
  [[nodiscard]] bool is_occluded(const Ray& ray) const;
  [[nodiscard]] HitBlock nearest(const RayBlock& rays, LaneMask lanes, Coherence coherence) const;
  [[nodiscard]] LaneMask are_occluded(const RayBlock& rays, LaneMask lanes) const;

  static void record_error(void* state, RTCError code, const char* text);
  static bool count_bytes(void* state, ssize_t bytes, bool is_done);
};

}  // namespace candela
