#include "renderer/accel/embree_accel.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <mutex>
#include <new>
#include <stdexcept>

#include "renderer/accel/alpha_test.h"
#include "renderer/accel/embree_api.h"
#include "renderer/accel/embree_block.h"
#include "renderer/accel/embree_spheres.h"
#include "renderer/accel/few_faces.h"
#include "renderer/accel/placement.h"
#include "renderer/accel/probe_walks.h"
#include "renderer/base/handover.h"
#include "renderer/base/parallel.h"
#include "renderer/math/float4.h"

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

Lanes<float> nearer(const Lanes<float>& a, const Lanes<float>& b) {
  Lanes<float> least;
  for (std::size_t i = 0; i < block_size; ++i) least[i] = std::min(a[i], b[i]);
  return least;
}

// From Embree's IDs to the scene's.
Hit in_tables_of_instance(const Scene& scene, Hit hit) {
  hit.instance = instance_of_id(scene, hit.instance);
  const Object& object = scene.objects[scene.instances[hit.instance].object.index];
  hit.geometry = object.geometries[hit.geometry].index;
  return hit;
}
inline Hit in_tables(const Scene& scene, const Hit& hit) {
  return hit.is_instanced() ? in_tables_of_instance(scene, hit) : hit;
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
  std::vector<EmbreeUserData> user_data;  // by geometry
  // Released in reverse order, and Embree reports every release to `bytes`.
  Device device;
  std::vector<EmbreeScene> objects;
  EmbreeScene world;
  EmbreeScene rest;  // what no list of faces has; null where there is nothing, or no list
  FewFaces few;

  State(const Scene& s, EmbreeOptions o) : scene(&s), options(o) {
    if (o.faces) few = find_few_faces(s);
  }

  void open_device();
  void build();
  [[nodiscard]] EmbreeScene new_scene() const;
  // Of geometries of the world, which keep their index as ID.
  [[nodiscard]] EmbreeScene scene_of(std::span<const GeometryHandle> geometries);
  // Of rays that go where paths do those that enter a box of the rest.
  [[nodiscard]] double share_of_entering_rays() const;
  [[nodiscard]] EmbreeGeometry triangles_of(std::uint32_t index);
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

  // By the list of faces, where there is one.
  [[nodiscard]] Hit nearest(const Ray& ray) const;
  [[nodiscard]] bool is_occluded(const Ray& ray) const;
  [[nodiscard]] HitBlock nearest(const RayBlock& rays, LaneMask lanes, Coherence coherence) const;
  [[nodiscard]] LaneMask are_occluded(const RayBlock& rays, LaneMask lanes) const;

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
  rest = scene_of(few.rest);
  rtcCommitScene(rest.get());
  throw_if_failed();
  if (options.faces_always || pays(few.faces.size(), share_of_entering_rays())) return;
  few = {};
  rest.reset();
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
    Hit hit = few.faces.intersect(ray).value_or(Hit{});
    const Ray before{ray.origin, ray.direction, hit.t};
    ++rays;
    if (few.boxes.is_entered(before)) {
      ++entering;
      if (const Hit nearer = intersect(rest.get(), before); nearer.is_hit()) hit = nearer;
    }
    return hit;
  });
  return rays > 0 ? entering / rays : 1;
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

Hit EmbreeAccel::State::intersect(RTCScene in, const Ray& ray) const {
  embree::Query query;
  embree::initialise(query, &ray, nullptr);
  RTCRayHit ray_hit;
  set_ray(ray_hit.ray, ray);
  ray_hit.hit.geomID = none;
  ray_hit.hit.instID[0] = none;
  embree::intersect_one(in, ray_hit, query);

  const RTCHit& found = ray_hit.hit;
  if (found.geomID == none) return {};
  return in_tables(
      *scene, {ray_hit.ray.tfar, found.u, found.v, found.geomID, found.primID, found.instID[0]});
}

bool EmbreeAccel::State::occluded(RTCScene in, const Ray& ray) const {
  embree::Query query;
  embree::initialise(query, &ray, nullptr);
  RTCRay embree_ray;
  set_ray(embree_ray, ray);
  embree::occluded_one(in, embree_ray, query);
  return embree_ray.tfar < 0;  // Embree's mark of an occluded ray: -infinity
}

HitBlock EmbreeAccel::State::intersect(RTCScene in, const RayBlock& rays, LaneMask lanes,
                                       Coherence coherence) const {
  embree::Query query;
  embree::initialise(query, nullptr, &rays);
  RTCRayHit16 ray_hits;
  const ValidLanes valid = set_rays(rays, lanes, ray_hits.ray);
  std::fill_n(ray_hits.hit.geomID, block_size, none);
  std::fill_n(ray_hits.hit.instID[0], block_size, none);
  embree::intersect_block(in, valid.lanes.data(), ray_hits, query, coherence);

  HitBlock hits;
  set_hits(ray_hits, hits);
  for_each_lane(hits.instanced,
                [&](std::uint32_t i) { hits.set(i, in_tables_of_instance(*scene, hits[i])); });
  return hits;
}

LaneMask EmbreeAccel::State::occluded(RTCScene in, const RayBlock& rays, LaneMask lanes) const {
  embree::Query query;
  embree::initialise(query, nullptr, &rays);
  RTCRay16 embree_rays;
  const ValidLanes valid = set_rays(rays, lanes, embree_rays);
  embree::occluded_block(in, valid.lanes.data(), embree_rays, query);
  return occluded_lanes(embree_rays) & lanes;
}

// What the list of faces does not know for certain the tree of everything is asked for. Else the
// rest is, where a ray enters one of its boxes before it meets a face.
Hit EmbreeAccel::State::nearest(const Ray& ray) const {
  if (few.faces.is_empty()) return intersect(world.get(), ray);
  const std::optional<Hit> known = few.faces.intersect(ray);
  if (!known) return intersect(world.get(), ray);
  if (!rest) return *known;
  const Ray before{ray.origin, ray.direction, std::min(ray.t_max, known->t)};
  if (!few.boxes.is_entered(before)) return *known;
  const Hit hit = intersect(rest.get(), before);
  return hit.is_hit() ? hit : *known;
}

bool EmbreeAccel::State::is_occluded(const Ray& ray) const {
  if (few.faces.is_empty()) return occluded(world.get(), ray);
  const std::optional<bool> known = few.faces.occluded(ray);
  if (!known) return occluded(world.get(), ray);
  if (*known || !rest || !few.boxes.is_entered(ray)) return *known;
  return occluded(rest.get(), ray);
}

HitBlock EmbreeAccel::State::nearest(const RayBlock& rays, LaneMask lanes,
                                     Coherence coherence) const {
  if (few.faces.is_empty()) return intersect(world.get(), rays, lanes, coherence);
  FaceList::BlockAnswer answer = few.faces.intersect(rays, lanes);
  for_each_lane(answer.open,
                [&](std::uint32_t i) { answer.hits.set(i, intersect(world.get(), rays[i])); });
  if (!rest) return answer.hits;
  RayBlock before = rays;
  before.t_max = nearer(rays.t_max, answer.hits.t);
  const LaneMask entering = few.boxes.entered(before, lanes & ~answer.open);
  const auto take = [&](std::uint32_t i, const Hit& hit) {
    if (hit.is_hit()) answer.hits.set(i, hit);
  };
  if (coherence == Coherence::Incoherent) {
    for_each_lane(entering, [&](std::uint32_t i) { take(i, intersect(rest.get(), before[i])); });
  } else if (entering != 0) {
    const HitBlock hits = intersect(rest.get(), before, entering, coherence);
    for_each_lane(entering, [&](std::uint32_t i) { take(i, hits[i]); });
  }
  return answer.hits;
}

LaneMask EmbreeAccel::State::are_occluded(const RayBlock& rays, LaneMask lanes) const {
  if (few.faces.is_empty()) return occluded(world.get(), rays, lanes);
  FaceList::BlockOcclusion answer = few.faces.occluded(rays, lanes);
  for_each_lane(answer.open, [&](std::uint32_t i) {
    if (occluded(world.get(), rays[i])) answer.occluded |= 1u << i;
  });
  if (!rest) return answer.occluded;
  for_each_lane(few.boxes.entered(rays, lanes & ~answer.open & ~answer.occluded),
                [&](std::uint32_t i) {
                  if (occluded(rest.get(), rays[i])) answer.occluded |= 1u << i;
                });
  return answer.occluded;
}

Hit EmbreeAccel::intersect(const Ray& ray) const {
  return state_->nearest(ray);
}

bool EmbreeAccel::occluded(const Ray& ray) const {
  return state_->is_occluded(ray);
}

HitBlock EmbreeAccel::intersect(const RayBlock& rays, LaneMask lanes, Coherence coherence) const {
  return state_->nearest(rays, lanes, coherence);
}

LaneMask EmbreeAccel::occluded(const RayBlock& rays, LaneMask lanes) const {
  return state_->are_occluded(rays, lanes);
}

bool EmbreeAccel::allows_any_company() const {
  return !state_->few.faces.is_empty();
}

Hit EmbreeAccel::intersect_by_tree(const Ray& ray) const {
  return state_->intersect(state_->world.get(), ray);
}

bool EmbreeAccel::occluded_by_tree(const Ray& ray) const {
  return state_->occluded(state_->world.get(), ray);
}

std::size_t EmbreeAccel::face_count() const {
  return state_->few.faces.size();
}

std::size_t EmbreeAccel::box_count() const {
  return state_->few.boxes.size();
}

std::size_t EmbreeAccel::memory_bytes() const {
  return state_->bytes;
}

const char* embree_version() {
  return RTC_VERSION_STRING;
}

}  // namespace candela
