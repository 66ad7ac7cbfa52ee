#include "renderer/accel/sphere_list.h"

#include <cmath>
#include <limits>

#include "renderer/accel/sphere_hit.h"
#include "renderer/base/floating_point_traps.h"
#include "renderer/base/vector_widths.h"
#include "renderer/math/constants.h"
#include "renderer/scene/scene.h"

namespace candela {
namespace {

// Bounds what floats are wrong by where they tell how far a ray passes a sphere's centre, over how
// far both are from the scene's: sixteen roundings of three coordinates each.
constexpr float doubt = gamma_bound(48);

// What all spheres ask of a ray. Where floats lose the direction's square, all of it but the doubt
// is NaN, of which nothing follows.
struct RayBounds {
  float length, inverse_length2;
  float doubt;  // of places on it
  float end;    // t_max times the direction's square, and more than that is wrong by
};
RayBounds bounds_of(const Vec3f& origin, const Vec3f& direction, float t_max) {
  constexpr float least = 1e-30f;
  const float square = dot(direction, direction);
  const float length2 = square > least ? square : std::numeric_limits<float>::quiet_NaN();
  return {std::sqrt(length2), 1 / length2, doubt * sum_of_absolutes(origin),
          t_max * length2 * (1 + doubt)};
}

// Whether nothing says that a ray does not meet a sphere before it ends.
std::uint32_t may_meet(const Vec3f& centre, float reach, const Vec3f& origin,
                       const Vec3f& direction, const RayBounds& ray) {
  Vec3f from_centre = origin - centre;
  const float along = -dot(from_centre, direction);  // to the chord's middle, times the length
  Vec3f beside = from_centre + direction * (along * ray.inverse_length2);
  const float limit = reach + ray.doubt;
  const float half = limit * ray.length;
  return flag(!(dot(beside, beside) > limit * limit)) & flag(!(along < -half)) &
         flag(!(along > ray.end + half));
}

// By sphere the lanes whose rays may meet it.
CANDELA_LANES void find_candidates(const SphereLanes& spheres, std::size_t count,
                                   const RayBlock& rays, Lanes<LaneMask>& candidates) {
  Lanes<float> length, inverse_length2, place_doubt, end;
  for (std::size_t i = 0; i < block_size; ++i) {
    const RayBounds ray = bounds_of(rays.origin[i], rays.direction[i], rays.t_max[i]);
    length[i] = ray.length;
    inverse_length2[i] = ray.inverse_length2;
    place_doubt[i] = ray.doubt;
    end[i] = ray.end;
  }
  for (std::size_t k = 0; k < count; ++k) {
    LaneFlags flags;
    for (std::size_t i = 0; i < block_size; ++i)
      flags[i] = may_meet(spheres.centre[k], spheres.reach[k], rays.origin[i], rays.direction[i],
                          {length[i], inverse_length2[i], place_doubt[i], end[i]});
    candidates[k] = mask_of(flags);
  }
}

// The spheres that one ray may meet.
CANDELA_LANES LaneMask candidates_of(const SphereLanes& spheres, const Ray& ray) {
  Vec3f origin = ray.origin;
  Vec3f direction = ray.direction;
  const RayBounds bounds = bounds_of(origin, direction, ray.t_max);
  LaneFlags flags;
  for (std::size_t k = 0; k < block_size; ++k)
    flags[k] = may_meet(spheres.centre[k], spheres.reach[k], origin, direction, bounds);
  return mask_of(flags);
}

// Sixteen rays with a sphere each.
struct Meetings {
  Vec3dLanes from_centre, direction;
  Lanes<double> radius{}, t_max{};

  void set(std::size_t i, const Sphere& sphere, const Ray& ray) {
    from_centre.set(i, Vec3d(ray.origin) - Vec3d(sphere.centre));
    direction.set(i, Vec3d(ray.direction));
    radius[i] = sphere.radius;
    t_max[i] = ray.t_max;
  }
};

// Where rays meet their spheres first; infinity where they do not.
CANDELA_LANES void find_meetings(const Meetings& meetings, Lanes<double>& t) {
  for (std::size_t i = 0; i < block_size; ++i) {
    const SphereChord chord =
        chord_of(meetings.from_centre[i], meetings.direction[i], meetings.radius[i]);
    const double half = std::sqrt(chord.half2);  // NaN where the ray passes by
    const double near = chord.middle - half;
    const double far = chord.middle + half;
    const double second = is_on_ray(far, meetings.t_max[i]) ? far : infinity;
    t[i] = is_on_ray(near, meetings.t_max[i]) ? near : second;
  }
}

}  // namespace

SphereList::SphereList(const Scene& scene, std::span<const GeometryHandle> geometries) {
  for (const GeometryHandle handle : geometries) {
    const std::vector<Sphere>& spheres = scene.geometries[handle.index].spheres;
    for (std::uint32_t i = 0; i < spheres.size(); ++i)
      spheres_.push_back({spheres[i], handle.index, i});
  }
  if (size() > most_spheres) spheres_.clear();
  for (std::size_t k = 0; k < size(); ++k) {
    const Sphere& sphere = spheres_[k].sphere;
    lanes_.centre.set(k, sphere.centre);
    lanes_.reach[k] = sphere.radius * (1 + doubt) + doubt * sum_of_absolutes(sphere.centre);
  }
}

Hit SphereList::hit_of(const Listed& listed, const Ray& ray) const {
  const SphereHit hit =
      intersect_sphere(listed.sphere, ray, ray.t_max, [](float, float) { return true; });
  if (!hit.is_hit()) return {};
  return {
      .t = hit.t, .u = hit.u, .v = hit.v, .geometry = listed.geometry, .triangle = listed.index};
}

template <class Visit>
void SphereList::for_each_meeting(const RayBlock& rays, LaneMask lanes, const Visit& visit) const {
  const FloatingPointTraps traps(Traps::Off);  // lanes that no ray fills may hold anything
  Lanes<LaneMask> candidates;
  find_candidates(lanes_, size(), rays, candidates);
  Meetings meetings;
  Lanes<std::uint32_t> lane, sphere;
  std::size_t count = 0;
  const auto meet = [&] {
    Lanes<double> t;
    find_meetings(meetings, t);
    for (std::size_t i = 0; i < count; ++i)
      if (t[i] < infinity) visit(lane[i], sphere[i], static_cast<float>(t[i]));
    count = 0;
  };
  for (std::uint32_t k = 0; k < size(); ++k)
    for_each_lane(candidates[k] & lanes, [&](std::uint32_t i) {
      meetings.set(count, spheres_[k].sphere, rays[i]);
      lane[count] = i;
      sphere[count] = k;
      if (++count == block_size) meet();
    });
  if (count > 0) meet();
}

void SphereList::intersect(const RayBlock& rays, LaneMask lanes, HitBlock& hits) const {
  Lanes<float> nearest;
  nearest.fill(infinity);
  Lanes<std::uint32_t> sphere;
  LaneMask met = 0;
  for_each_meeting(rays, lanes, [&](std::uint32_t i, std::uint32_t k, float t) {
    if (!(t < nearest[i])) return;
    nearest[i] = t;
    sphere[i] = k;
    met |= 1u << i;
  });
  for_each_lane(met, [&](std::uint32_t i) { hits.set(i, hit_of(spheres_[sphere[i]], rays[i])); });
}

LaneMask SphereList::occluded(const RayBlock& rays, LaneMask lanes) const {
  LaneMask met = 0;
  for_each_meeting(rays, lanes, [&](std::uint32_t i, std::uint32_t, float) { met |= 1u << i; });
  return met;
}

Hit SphereList::intersect(const Ray& ray) const {
  Hit nearest;
  const LaneMask listed = (1u << size()) - 1;
  for_each_lane(candidates_of(lanes_, ray) & listed, [&](std::uint32_t k) {
    const Hit hit = hit_of(spheres_[k], ray);
    if (hit.t < nearest.t) nearest = hit;
  });
  return nearest;
}

bool SphereList::occluded(const Ray& ray) const {
  return intersect(ray).is_hit();
}

}  // namespace candela
