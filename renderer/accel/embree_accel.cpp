#include "renderer/accel/embree_accel.h"

#include <atomic>
#include <cstring>
#include <mutex>
#include <new>
#include <stdexcept>

#include "renderer/accel/alpha_test.h"
#include "renderer/accel/embree_api.h"
#include "renderer/accel/placement.h"
#include "renderer/base/handover.h"
#include "renderer/base/parallel.h"

namespace candela {
namespace {

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

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
static_assert(none == RTC_INVALID_GEOMETRY_ID);
static_assert(RTC_MAX_INSTANCE_LEVEL_COUNT == 1);

// What a filter function is told of the geometry that it is called for.
struct Cutout {
  const Scene* scene = nullptr;
  std::uint32_t geometry = none;
};

// Called for single rays only. An instance's ID in the top level is the count of geometries plus
// its index.
void let_light_through(const RTCFilterFunctionNArguments* arguments) {
  const auto& query = *reinterpret_cast<const embree::Query*>(arguments->context);
  const Cutout& cutout = *static_cast<const Cutout*>(arguments->geometryUserPtr);
  RTCHitN* hit = arguments->hit;
  const std::uint32_t id = RTCHitN_instID(hit, 1, 0, 0);
  const std::uint32_t instance =
      id == none ? none : id - static_cast<std::uint32_t>(cutout.scene->geometries.size());
  const bool is_clear = is_transparent_at(*cutout.scene, cutout.geometry, RTCHitN_primID(hit, 1, 0),
                                          instance, RTCHitN_u(hit, 1, 0), RTCHitN_v(hit, 1, 0),
                                          query.world_ray->origin, query.world_ray->direction);
  if (is_clear) arguments->valid[0] = 0;
}

// Four floats at once: Embree loads origin and direction as vectors, and a vector load cannot be
// forwarded from four narrower stores that are still under way.
void store_four(float* target, const Vec3f& v, float last) {
  typedef float Float4 __attribute__((vector_size(16), may_alias));
  *reinterpret_cast<Float4*>(target) = Float4{v.x, v.y, v.z, last};
}

void set_ray(RTCRay& target, const Ray& ray) {
  store_four(&target.org_x, ray.origin, 0.0f);     // tnear
  store_four(&target.dir_x, ray.direction, 0.0f);  // time
  target.tfar = ray.t_max;
  target.mask = none;
  target.id = 0;
  target.flags = 0;
}

}  // namespace

struct EmbreeAccel::State {
  const Scene* scene = nullptr;
  EmbreeOptions options;
  Handover callbacks;  // Embree calls back from threads of its own
  std::atomic<std::size_t> bytes{0};
  std::mutex error_mutex;
  RTCError error = RTC_ERROR_NONE;
  std::string error_text;
  std::vector<Cutout> cutouts;  // by geometry
  // Released in reverse order, and Embree reports every release to `bytes`.
  Device device;
  std::vector<EmbreeScene> objects;
  EmbreeScene world;

  State(const Scene& s, EmbreeOptions o) : scene(&s), options(o) {}

  void open_device();
  void build();
  [[nodiscard]] EmbreeScene new_scene() const;
  [[nodiscard]] EmbreeGeometry triangles_of(std::uint32_t index);
  void attach_geometry(RTCScene target, std::uint32_t index, std::uint32_t id);
  void attach_instance(std::size_t index);
  void build_object(std::size_t index);
  void throw_if_failed();

  static void record_error(void* state, RTCError code, const char* text);
  static bool count_bytes(void* state, ssize_t bytes, bool is_done);
};

void EmbreeAccel::State::record_error(void* state, RTCError code, const char* text) {
  State& self = *static_cast<State*>(state);
  self.callbacks.enter();
  const std::lock_guard lock(self.error_mutex);
  // A failed allocation explains what fails after it.
  if (self.error != RTC_ERROR_NONE && code != RTC_ERROR_OUT_OF_MEMORY) return;
  self.error = code;
  self.error_text = text ? text : "";
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
  throw std::runtime_error("Embree: " + error_text);
}

void EmbreeAccel::State::open_device() {
  device.reset(rtcNewDevice(nullptr));
  if (!device) throw std::runtime_error("Embree cannot open a device on this processor");
  callbacks.begin();
  rtcSetDeviceErrorFunction(device.get(), record_error, this);
  rtcSetDeviceMemoryMonitorFunction(device.get(), count_bytes, this);
}

EmbreeScene EmbreeAccel::State::new_scene() const {
  EmbreeScene made(rtcNewScene(device.get()));
  rtcSetSceneBuildQuality(made.get(), RTC_BUILD_QUALITY_HIGH);
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
  rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
  if (source.has_cutouts) {
    cutouts[index] = {scene, index};
    rtcSetGeometryUserData(geometry, &cutouts[index]);
    rtcSetGeometryIntersectFilterFunction(geometry, let_light_through);
    rtcSetGeometryOccludedFilterFunction(geometry, let_light_through);
  }
  rtcCommitGeometry(geometry);
  return made;
}

void EmbreeAccel::State::attach_geometry(RTCScene target, std::uint32_t index, std::uint32_t id) {
  const Geometry& source = scene->geometries[index];
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

// The world's geometries keep their index as ID, so that a hit of the world needs no table.
void EmbreeAccel::State::build() {
  cutouts.resize(scene->geometries.size());
  objects.resize(scene->objects.size());
  parallel_for(objects.size(), [&](std::size_t i) { build_object(i); });
  throw_if_failed();
  world = new_scene();
  for (const GeometryHandle geometry : scene->world.geometries)
    attach_geometry(world.get(), geometry.index, geometry.index);
  for (std::size_t i = 0; i < scene->instances.size(); ++i) attach_instance(i);
  rtcCommitScene(world.get());
  throw_if_failed();
}

EmbreeAccel::EmbreeAccel(const Scene& scene, EmbreeOptions options)
    : state_(std::make_unique<State>(scene, options)) {
  without_traps([&] {
    state_->open_device();
    state_->build();
  });
}
EmbreeAccel::EmbreeAccel(EmbreeAccel&&) noexcept = default;
EmbreeAccel& EmbreeAccel::operator=(EmbreeAccel&&) noexcept = default;
EmbreeAccel::~EmbreeAccel() = default;

Hit EmbreeAccel::intersect(const Ray& ray) const {
  embree::Query query;
  embree::initialise(query, ray);
  RTCRayHit ray_hit;
  set_ray(ray_hit.ray, ray);
  ray_hit.hit.geomID = none;
  ray_hit.hit.instID[0] = none;
  embree::intersect_one(state_->world.get(), ray_hit, query);

  const RTCHit& found = ray_hit.hit;
  if (found.geomID == none) return {};
  Hit hit{ray_hit.ray.tfar, found.u, found.v, found.geomID, found.primID, none};
  if (found.instID[0] != none) {
    const Scene& scene = *state_->scene;
    hit.instance = found.instID[0] - static_cast<std::uint32_t>(scene.geometries.size());
    const Object& object = scene.objects[scene.instances[hit.instance].object.index];
    hit.geometry = object.geometries[found.geomID].index;
  }
  return hit;
}

bool EmbreeAccel::occluded(const Ray& ray) const {
  embree::Query query;
  embree::initialise(query, ray);
  RTCRay embree_ray;
  set_ray(embree_ray, ray);
  embree::occluded_one(state_->world.get(), embree_ray, query);
  return embree_ray.tfar < 0;  // Embree's mark of an occluded ray: -infinity
}

std::size_t EmbreeAccel::memory_bytes() const {
  return state_->bytes;
}

const char* embree_version() {
  return RTC_VERSION_STRING;
}

}  // namespace candela
