#include <algorithm>
#include <cstring>
#include <new>
#include <stdexcept>

#include <fmt/format.h>

#include "renderer/accel/alpha_test.h"
#include "renderer/accel/embree_state.h"
#include "renderer/accel/placement.h"
#include "renderer/accel/probe_walks.h"
#include "renderer/base/parallel.h"
#include "renderer/math/float4.h"

namespace candela {
namespace {

using embree::none;

bool is_clear_in_lane(const RTCFilterFunctionNArguments& arguments, unsigned n, unsigned lane) {
  const auto& query = *reinterpret_cast<const embree::Query*>(arguments.context);
  const auto& cutout = *static_cast<const EmbreeUserData*>(arguments.geometryUserPtr);
  RTCHitN* hit = arguments.hit;
  const std::uint32_t instance = instance_of_id(*cutout.scene, RTCHitN_instID(hit, n, lane, 0));
  const Ray ray = query.world_ray(RTCRayN_id(arguments.ray, n, lane));
  return is_transparent_at(*cutout.scene, cutout.geometry, RTCHitN_primID(hit, n, lane), instance,
                           RTCHitN_u(hit, n, lane), RTCHitN_v(hit, n, lane), ray.origin,
                           ray.direction);
}

// Which of the four lanes from the first one on ask: 0 or -1.
int asking_lanes(const int* valid) {
  Mask4 lanes;
  std::memcpy(&lanes, valid, sizeof(lanes));
  return mask_of(lanes);
}

// One ray, or four, eight or sixteen, of which mostly one asks.
void let_light_through(const RTCFilterFunctionNArguments* arguments) {
  const unsigned n = arguments->N;
  if (n == 1) {
    if (is_clear_in_lane(*arguments, 1, 0)) arguments->valid[0] = 0;
    return;
  }
  for (unsigned first = 0; first < n; first += 4)
    for (int mask = asking_lanes(arguments->valid + first); mask != 0; mask &= mask - 1) {
      const unsigned lane = first + static_cast<unsigned>(lowest_lane(mask));
      if (is_clear_in_lane(*arguments, n, lane)) arguments->valid[lane] = 0;
    }
}

}  // namespace

using embree::EmbreeGeometry;
using embree::EmbreeScene;

void EmbreeAccel::State::record_error(void* state, RTCError code, const char* text) {
  State& self = *static_cast<State*>(state);
  self.callbacks.enter();
  const std::lock_guard lock(self.error_mutex);
  // A failed allocation explains what fails after it.
  if (self.error == RTC_ERROR_NONE || code == RTC_ERROR_OUT_OF_MEMORY) {
    self.error = code;
    std::strncpy(self.error_text.data(), text ? text : "", self.error_text.size() - 1);
  }
  self.callbacks.leave();
}

bool EmbreeAccel::State::count_bytes(void* state, ssize_t bytes, bool /*is_done*/) {
  State& self = *static_cast<State*>(state);
  self.callbacks.enter();
  const std::size_t now = self.bytes += static_cast<std::size_t>(bytes);
  self.callbacks.leave();
  return bytes <= 0 || self.options.memory_limit_bytes == 0 ||
         now <= self.options.memory_limit_bytes;
}

void EmbreeAccel::State::throw_if_failed() {
  callbacks.end();
  if (error == RTC_ERROR_NONE) return;
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  throw std::runtime_error(fmt::format("Embree: {}", error_text.data()));
}

PacketRules packet_rules_of(RTCDevice device) {
  if (embree::has_packets<16>(device)) return {16, 4, 4, 1};
  if (embree::has_packets<8>(device)) return {8, 3, 4, 4};
  return no_packets;
}

void EmbreeAccel::State::open_device() {
  device.reset(rtcNewDevice(nullptr));
  if (!device) {
    const RTCError why = rtcGetDeviceError(nullptr);
    if (why == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    throw std::runtime_error(
        fmt::format("Embree cannot open a device on this processor (error {})", int{why}));
  }
  packets = options.packets ? packet_rules_of(device.get()) : no_packets;
  callbacks.begin();
  rtcSetDeviceErrorFunction(device.get(), record_error, this);
  rtcSetDeviceMemoryMonitorFunction(device.get(), count_bytes, this);
}

RTCBuildQuality EmbreeAccel::State::quality() const {
  return options.high_quality ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM;
}

EmbreeScene EmbreeAccel::State::new_scene() const {
  EmbreeScene made(rtcNewScene(device.get()));
  rtcSetSceneBuildQuality(made.get(), quality());
  rtcSetSceneFlags(made.get(), options.robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
  return made;
}

EmbreeGeometry EmbreeAccel::State::triangles_of(std::uint32_t index) {
  const Geometry& source = scene->geometries[index];
  EmbreeGeometry made(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
  RTCGeometry geometry = made.get();
  const auto& positions = source.positions;
  if (positions.capacity() > positions.size()) {
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               positions.data(), 0, sizeof(Vec3f), positions.size());
  } else if (void* copy =
                 rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                         sizeof(Vec3f), positions.size())) {
    std::memcpy(copy, positions.data(), positions.size() * sizeof(Vec3f));
  }
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             source.triangles.data(), 0, 3 * sizeof(std::uint32_t),
                             source.triangles.size());
  rtcSetGeometryMask(geometry, none);  // Embree 4's default sees the lowest bit only
  rtcSetGeometryBuildQuality(geometry, quality());
  if (source.has_cutouts) {
    rtcSetGeometryUserData(geometry, &user_data[index]);
    rtcSetGeometryIntersectFilterFunction(geometry, let_light_through);
    rtcSetGeometryOccludedFilterFunction(geometry, let_light_through);
  }
  rtcCommitGeometry(geometry);
  return made;
}

void EmbreeAccel::State::attach_geometry(RTCScene target, std::uint32_t index, std::uint32_t id) {
  const Geometry& source = scene->geometries[index];
  user_data[index] = {scene, index};
  // No exception leaves Embree's callbacks: they must find what they look at.
  if (source.has_cutouts)
    scene->textures.decode(scene->materials[source.material.index].opacity.texture);
  if (!source.spheres.empty()) {
    const EmbreeGeometry spheres(new_embree_spheres(device.get(), user_data[index]));
    rtcAttachGeometryByID(target, spheres.get(), id);
  }
  if (source.triangles.empty() || source.positions.empty()) return;
  rtcAttachGeometryByID(target, triangles_of(index).get(), id);
}

// IDs count the object's own geometries from 0: an object of one geometry among a million must not
// bring a table of a million IDs.
void EmbreeAccel::State::build_object(std::size_t index) {
  objects[index] = new_scene();
  const auto& geometries = scene->objects[index].geometries;
  for (std::size_t i = 0; i < geometries.size(); ++i)
    attach_geometry(objects[index].get(), geometries[i].index, static_cast<std::uint32_t>(i));
  rtcCommitScene(objects[index].get());
}

void EmbreeAccel::State::attach_instance(std::size_t index) {
  const Instance& source = scene->instances[index];
  if (!world_to_object(source)) return;
  const float columns[12] = {source.x.x,           source.x.y,           source.x.z,
                             source.y.x,           source.y.y,           source.y.z,
                             source.z.x,           source.z.y,           source.z.z,
                             source.translation.x, source.translation.y, source.translation.z};
  const EmbreeGeometry made(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE));
  rtcSetGeometryInstancedScene(made.get(), objects[source.object.index].get());
  rtcSetGeometryTransform(made.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
  rtcSetGeometryMask(made.get(), none);
  rtcCommitGeometry(made.get());
  rtcAttachGeometryByID(world.get(), made.get(),
                        static_cast<std::uint32_t>(scene->geometries.size() + index));
}

// A hit of the world needs no table.
void EmbreeAccel::State::build() {
  user_data.resize(scene->geometries.size());
  objects.resize(scene->objects.size());
  parallel_for(objects.size(), [&](std::size_t i) { build_object(i); });
  throw_if_failed();
  world = scene_of(scene->world.geometries);
  for (std::size_t i = 0; i < scene->instances.size(); ++i) attach_instance(i);
  rtcCommitScene(world.get());
  throw_if_failed();
  if (few.boxes.is_empty()) return;
  if (!options.faces_always &&
      !pays(few.faces.size() + few.spheres.size(), share_of_entering_rays())) {
    few = {};
    return;
  }
  rest = scene_of(few.rest);
  rtcCommitScene(rest.get());
  throw_if_failed();
}

EmbreeScene EmbreeAccel::State::scene_of(std::span<const GeometryHandle> geometries) {
  EmbreeScene made = new_scene();
  for (const GeometryHandle geometry : geometries)
    attach_geometry(made.get(), geometry.index, geometry.index);
  return made;
}

double EmbreeAccel::State::share_of_entering_rays() const {
  double rays = 0;
  double entering = 0;
  probe_walks(*scene, [&](const Ray& ray) {
    const float to_face = few.faces.intersect(ray).value_or(Hit{}).t;
    const float to_sphere = few.spheres.intersect(ray).t;
    ++rays;
    if (few.boxes.is_entered({ray.origin, ray.direction, std::min(to_face, to_sphere)})) ++entering;
    return intersect(world.get(), ray);
  });
  return rays > 0 ? entering / rays : 1;
}

}  // namespace candela
