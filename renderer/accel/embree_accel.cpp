#include "renderer/accel/embree_accel.h"

#include <algorithm>

#include "renderer/accel/embree_block.h"
#include "renderer/accel/embree_state.h"
#include "renderer/base/parallel.h"

namespace candela {
namespace {

using embree::least_t;
using embree::none;

// Four floats at once: Embree loads origin and direction as vectors, and a vector load cannot be
// forwarded from four narrower stores that are still under way.
void store_four(float* target, const Vec3f& v, float last) {
#ifndef CANDELA_WITHOUT_VECTOR_RAY_SETUP
  typedef float Float4 __attribute__((vector_size(16), may_alias));
  *reinterpret_cast<Float4*>(target) = Float4{v.x, v.y, v.z, last};
#else
  volatile float* numbers = target;  // else the compiler would make one store of them
  numbers[0] = v.x;
  numbers[1] = v.y;
  numbers[2] = v.z;
  numbers[3] = last;
#endif
}

void set_ray(RTCRay& target, const Ray& ray) {
  store_four(&target.org_x, ray.origin, least_t);  // tnear
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

// A list of faces is asked for fewer rays one by one.
constexpr std::uint32_t fewest_of_list = 4;

// Calls visit(lanes, first) for those lanes of each packet of a block that count.
void for_each_packet(std::uint32_t size, LaneMask lanes, const auto& visit) {
  const LaneMask packet = (1u << size) - 1;
  for (std::uint32_t first = 0; first < block_size; first += size)
    if (const LaneMask part = lanes & packet << first; part != 0) visit(part, first);
}

LaneMask lanes_where(LaneMask lanes, const auto& holds) {
  LaneMask found = 0;
  for_each_lane(lanes, [&](std::uint32_t i) {
    if (holds(i)) found |= 1u << i;
  });
  return found;
}

// Of what is met in an instance, from Embree's IDs to the scene's.
inline void find_in_tables(const Scene& scene, std::uint32_t& geometry, std::uint32_t& instance) {
  instance = instance_of_id(scene, instance);
  const Object& object = scene.objects[scene.instances[instance].object.index];
  geometry = object.geometries[geometry].index;
}

}  // namespace

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
  Hit hit{ray_hit.ray.tfar, found.u, found.v, found.geomID, found.primID, found.instID[0]};
  if (hit.is_instanced()) find_in_tables(*scene, hit.geometry, hit.instance);
  return hit;
}

bool EmbreeAccel::State::occluded(RTCScene in, const Ray& ray) const {
  embree::Query query;
  embree::initialise(query, &ray, nullptr);
  RTCRay embree_ray;
  set_ray(embree_ray, ray);
  embree::occluded_one(in, embree_ray, query);
  return embree_ray.tfar < 0;  // Embree's mark of an occluded ray: -infinity
}

template <std::size_t size>
void EmbreeAccel::State::intersect_packet(RTCScene in, const RayBlock& rays, LaneMask lanes,
                                          std::uint32_t first, Coherence coherence,
                                          HitBlock& hits) const {
  embree::Query query;
  embree::initialise(query, nullptr, &rays);
  typename embree::PacketTypes<size>::RayHit ray_hits;
  const ValidLanes<size> valid = set_rays(rays, lanes, first, ray_hits.ray);
  std::fill_n(ray_hits.hit.geomID, size, none);
  std::fill_n(ray_hits.hit.instID[0], size, none);
  embree::intersect_packet<size>(in, valid.lanes.data(), ray_hits, query, coherence);
  set_hits(ray_hits, first, hits);
  for_each_lane(hits.instanced & lanes, [&](std::uint32_t i) {
    find_in_tables(*scene, hits.geometry[i], hits.instance[i]);
  });
}

template <std::size_t size>
LaneMask EmbreeAccel::State::occluded_packet(RTCScene in, const RayBlock& rays, LaneMask lanes,
                                             std::uint32_t first) const {
  embree::Query query;
  embree::initialise(query, nullptr, &rays);
  typename embree::PacketTypes<size>::Ray embree_rays;
  const ValidLanes<size> valid = set_rays(rays, lanes, first, embree_rays);
  embree::occluded_packet<size>(in, valid.lanes.data(), embree_rays, query);
  return occluded_lanes(embree_rays, first) & lanes;
}

HitBlock EmbreeAccel::State::intersect(RTCScene in, const RayBlock& rays, LaneMask lanes,
                                       Coherence coherence) const {
  const std::uint32_t fewest =
      coherence == Coherence::Coherent ? packets.fewest_coherent : packets.fewest_incoherent;
  HitBlock hits;
  for_each_packet(packets.size, lanes, [&](LaneMask part, std::uint32_t first) {
    if (lane_count(part) < fewest)
      for_each_lane(part, [&](std::uint32_t i) { hits.set(i, intersect(in, rays[i])); });
    else if (packets.size == 16)
      intersect_packet<16>(in, rays, part, first, coherence, hits);
    else
      intersect_packet<8>(in, rays, part, first, coherence, hits);
  });
  return hits;
}

LaneMask EmbreeAccel::State::occluded(RTCScene in, const RayBlock& rays, LaneMask lanes) const {
  LaneMask found = 0;
  for_each_packet(packets.size, lanes, [&](LaneMask part, std::uint32_t first) {
    if (lane_count(part) < packets.fewest_shadow)
      found |= lanes_where(part, [&](std::uint32_t i) { return occluded(in, rays[i]); });
    else if (packets.size == 16)
      found |= occluded_packet<16>(in, rays, part, first);
    else
      found |= occluded_packet<8>(in, rays, part, first);
  });
  return found;
}

// What the list of faces does not know for certain the tree of everything is asked for. Else the
// rest is, where a ray enters one of its boxes before it meets a face or a sphere.
Hit EmbreeAccel::State::nearest(const Ray& ray) const {
  if (few.faces.is_empty()) return intersect(world.get(), ray);
  const std::optional<Hit> known = few.faces.intersect(ray);
  if (!known) return intersect(world.get(), ray);
  Hit nearest = *known;
  Ray before{ray.origin, ray.direction, std::min(ray.t_max, nearest.t)};
  const auto take = [&](const Hit& hit) {
    if (!hit.is_hit()) return;
    nearest = hit;
    before.t_max = hit.t;
  };
  if (!few.spheres.is_empty()) take(few.spheres.intersect(before));
  if (rest && few.boxes.is_entered(before)) take(intersect(rest.get(), before));
  return nearest;
}

bool EmbreeAccel::State::is_occluded(const Ray& ray) const {
  if (few.faces.is_empty()) return occluded(world.get(), ray);
  const std::optional<bool> known = few.faces.occluded(ray);
  if (!known) return occluded(world.get(), ray);
  if (*known || (!few.spheres.is_empty() && few.spheres.occluded(ray))) return true;
  return rest && few.boxes.is_entered(ray) && occluded(rest.get(), ray);
}

HitBlock EmbreeAccel::State::nearest(const RayBlock& rays, LaneMask lanes,
                                     Coherence coherence) const {
  if (few.faces.is_empty()) return intersect(world.get(), rays, lanes, coherence);
  FaceList::BlockAnswer answer = few.faces.intersect(rays, lanes);
  for_each_lane(answer.open,
                [&](std::uint32_t i) { answer.hits.set(i, intersect(world.get(), rays[i])); });
  if (!rest && few.spheres.is_empty()) return answer.hits;
  const LaneMask known = lanes & ~answer.open;
  RayBlock before = rays;
  before.t_max = nearer(rays.t_max, answer.hits.t);
  if (!few.spheres.is_empty()) {
    few.spheres.intersect(before, known, answer.hits);
    if (!rest) return answer.hits;
    before.t_max = nearer(rays.t_max, answer.hits.t);
  }
  const LaneMask entering = few.boxes.entered(before, known);
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
  answer.occluded |=
      lanes_where(answer.open, [&](std::uint32_t i) { return occluded(world.get(), rays[i]); });
  const auto left = [&] { return lanes & ~answer.open & ~answer.occluded; };
  if (!few.spheres.is_empty()) answer.occluded |= few.spheres.occluded(rays, left());
  if (!rest) return answer.occluded;
  return answer.occluded | lanes_where(few.boxes.entered(rays, left()), [&](std::uint32_t i) {
           return occluded(rest.get(), rays[i]);
         });
}

Hit EmbreeAccel::intersect(const Ray& ray) const {
  return state_->nearest(ray);
}

bool EmbreeAccel::occluded(const Ray& ray) const {
  return state_->is_occluded(ray);
}

HitBlock EmbreeAccel::intersect(const RayBlock& rays, LaneMask lanes, Coherence coherence) const {
  if (allows_any_company() && lane_count(lanes) < fewest_of_list)
    return intersect_one_by_one(*this, rays, lanes);
  return state_->nearest(rays, lanes, coherence);
}

LaneMask EmbreeAccel::occluded(const RayBlock& rays, LaneMask lanes) const {
  if (allows_any_company() && lane_count(lanes) < fewest_of_list)
    return occluded_one_by_one(*this, rays, lanes);
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

std::size_t EmbreeAccel::sphere_count() const {
  return state_->few.spheres.size();
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
