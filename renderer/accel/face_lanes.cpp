#include "renderer/accel/face_lanes.h"

#include "renderer/base/vector_widths.h"

namespace candela {
namespace {

struct DoubtLanes {
  Lanes<float> of_place, of_distance;
};

// Most planes are behind the rays, or behind what they met already.
[[gnu::always_inline]] inline void meet_with_all(const FaceGroup& faces, std::size_t k,
                                                 std::uint32_t number, const RayBlock& rays,
                                                 const DoubtLanes& doubts, FaceLanes& nearest) {
  Lanes<float> t, inverse;
  LaneFlags is_ahead;
  std::uint32_t any = 0;
  for (std::size_t i = 0; i < block_size; ++i) {
    const PlaneMeeting plane = meet_plane(faces, k, rays.origin[i], rays.direction[i]);
    t[i] = plane.t;
    inverse[i] = plane.inverse;
    is_ahead[i] = flag(plane.t > 0) & flag(plane.t < nearest.t[i]);
    any |= is_ahead[i];
  }
  if (any == 0) return;
  for (std::size_t i = 0; i < block_size; ++i) {
    const FaceVerdict verdict =
        judge(faces, k, rays.origin[i], rays.direction[i], {t[i], inverse[i]},
              {doubts.of_place[i], doubts.of_distance[i]});
    const std::uint32_t is_met = is_ahead[i] & verdict.is_inside;
    const std::uint32_t is_open = is_ahead[i] & verdict.is_open & flag(t[i] < nearest.open_t[i]);
    nearest.t[i] = is_met != 0 ? t[i] : nearest.t[i];
    nearest.face[i] = is_met != 0 ? number : nearest.face[i];
    nearest.open_t[i] = is_open != 0 ? t[i] : nearest.open_t[i];
  }
}

}  // namespace

CANDELA_LANES FaceLanes find_nearest_faces(const FaceGroups& faces, const RayBlock& rays) {
  FaceLanes nearest;
  DoubtLanes doubts;
  for (std::size_t i = 0; i < block_size; ++i) {
    const RayDoubt doubt = doubt_of(rays.origin[i], rays.direction[i], faces.reach);
    doubts.of_place[i] = doubt.of_place;
    doubts.of_distance[i] = doubt.of_distance;
    nearest.t[i] = rays.t_max[i];
    nearest.face[i] = FaceLanes::none;
    nearest.open_t[i] = std::numeric_limits<float>::infinity();
  }
  for (std::uint32_t number = 0; number < faces.size; ++number)
    meet_with_all(faces.groups[number / block_size], number % block_size, number, rays, doubts,
                  nearest);
  return nearest;
}

CANDELA_LANES NearestFace find_nearest_face(const FaceGroups& faces, const Ray& ray) {
  NearestFace nearest{ray.t_max, FaceLanes::none, false};
  float open_t = std::numeric_limits<float>::infinity();
  Vec3f origin = ray.origin;
  Vec3f direction = ray.direction;
  const float t_max = ray.t_max;
  const RayDoubt doubt = doubt_of(origin, direction, faces.reach);
  for (std::uint32_t first = 0; first < faces.size; first += block_size) {
    const FaceGroup& group = faces.groups[first / block_size];
    Lanes<float> t;
    LaneFlags met, open;
    for (std::size_t k = 0; k < block_size; ++k) {
      const PlaneMeeting plane = meet_plane(group, k, origin, direction);
      const FaceVerdict verdict = judge(group, k, origin, direction, plane, doubt);
      const std::uint32_t is_ahead = flag(plane.t > 0) & flag(plane.t < t_max);
      t[k] = plane.t;
      met[k] = is_ahead & verdict.is_inside;
      open[k] = is_ahead & verdict.is_open;
    }
    for_each_lane(mask_of(open), [&](std::uint32_t k) { open_t = t[k] < open_t ? t[k] : open_t; });
    for_each_lane(mask_of(met), [&](std::uint32_t k) {
      if (!(t[k] < nearest.t)) return;
      nearest.t = t[k];
      nearest.face = first + k;
    });
  }
  nearest.is_open = open_t < nearest.t;
  return nearest;
}

CANDELA_LANES LaneMask open_lanes(const FaceLanes& nearest) {
  LaneFlags flags;
  for (std::size_t i = 0; i < block_size; ++i) flags[i] = flag(nearest.open_t[i] < nearest.t[i]);
  return mask_of(flags);
}

CANDELA_LANES LaneMask lanes_with_face(const FaceLanes& nearest) {
  LaneFlags flags;
  for (std::size_t i = 0; i < block_size; ++i) flags[i] = flag(nearest.face[i] != FaceLanes::none);
  return mask_of(flags);
}

}  // namespace candela
