#include "renderer/accel/face_lanes.h"

#include "renderer/base/vector_widths.h"

namespace candela {
namespace {

// What a ray that goes as far as `t_max` knows of a face.
struct FaceVerdict {
  std::uint32_t is_met;  // for certain
  std::uint32_t is_open;
};
[[nodiscard]] inline FaceVerdict judge(const FaceMeeting& meeting, float t_max) {
  const std::uint32_t is_ahead = flag(meeting.t > 0) & flag(meeting.t < t_max);
  const std::uint32_t may_be_inside = flag(meeting.inside >= -meeting.doubt);
  const std::uint32_t is_inside = flag(meeting.inside > meeting.doubt);
  return {is_ahead & is_inside, is_ahead & may_be_inside & (is_inside ^ 1)};
}

struct DoubtLanes {
  Lanes<float> of_place, of_distance;
};

[[gnu::always_inline]] inline void meet_with_all(const FaceGroup& faces, std::size_t k,
                                                 std::uint32_t number, const RayBlock& rays,
                                                 const DoubtLanes& doubts, FaceLanes& nearest) {
  for (std::size_t i = 0; i < block_size; ++i) {
    const FaceMeeting meeting = meet_face(faces, k, rays.origin[i], rays.direction[i],
                                          {doubts.of_place[i], doubts.of_distance[i]});
    const FaceVerdict verdict = judge(meeting, rays.t_max[i]);
    const std::uint32_t is_nearer = verdict.is_met & flag(meeting.t < nearest.t[i]);
    nearest.t[i] = is_nearer != 0 ? meeting.t : nearest.t[i];
    nearest.face[i] = is_nearer != 0 ? number : nearest.face[i];
    nearest.is_open[i] |= verdict.is_open;
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
  }
  for (std::uint32_t number = 0; number < faces.size; ++number)
    meet_with_all(faces.groups[number / block_size], number % block_size, number, rays, doubts,
                  nearest);
  return nearest;
}

CANDELA_LANES NearestFace find_nearest_face(const FaceGroups& faces, const Ray& ray) {
  NearestFace nearest{ray.t_max, FaceLanes::none, false};
  Vec3f origin = ray.origin;
  Vec3f direction = ray.direction;
  const float t_max = ray.t_max;
  const RayDoubt doubt = doubt_of(origin, direction, faces.reach);
  for (std::uint32_t first = 0; first < faces.size; first += block_size) {
    const FaceGroup& group = faces.groups[first / block_size];
    Lanes<float> t;
    LaneFlags met, open;
    for (std::size_t k = 0; k < block_size; ++k) {
      const FaceMeeting meeting = meet_face(group, k, origin, direction, doubt);
      const FaceVerdict verdict = judge(meeting, t_max);
      t[k] = meeting.t;
      met[k] = verdict.is_met;
      open[k] = verdict.is_open;
    }
    nearest.is_open |= mask_of(open) != 0;
    for_each_lane(mask_of(met), [&](std::uint32_t k) {
      if (!(t[k] < nearest.t)) return;
      nearest.t = t[k];
      nearest.face = first + k;
    });
  }
  return nearest;
}

}  // namespace candela
