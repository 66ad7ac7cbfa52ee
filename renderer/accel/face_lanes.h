// Rays against flat faces: loops over lanes, of rays or of faces.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "renderer/accel/ray_block.h"
#include "renderer/math/constants.h"

namespace candela {

// Sixteen convex polygons of up to four corners, each in its plane. Places are relative to one of
// the corners.
struct FaceGroup {
  Vec3Lanes corner;
  Vec3Lanes normal;  // unit; 0 in lanes without a face, which no ray meets
  // How far a place in the plane is inside of an edge: its part along a unit vector, and a number.
  // Triangles have one edge twice.
  std::array<Vec3Lanes, 4> inward;
  std::array<Lanes<float>, 4> distance{};
};

struct FaceGroups {
  std::vector<FaceGroup> groups;
  std::uint32_t size = 0;  // faces: number sixteen g + i is in lane i of group g
  float reach = 0;         // the largest sum of a corner's absolute coordinates
};

// What bounds the errors of a ray's meetings.
struct RayDoubt {
  float of_place;
  float of_distance;  // times how far the ray goes while it comes nearer to the plane by 1
};
[[nodiscard]] inline RayDoubt doubt_of(const Vec3f& origin, const Vec3f& direction, float reach) {
  const float of_place = gamma_bound(16) * (sum_of_absolutes(origin) + reach);
  return {of_place, of_place * sum_of_absolutes(direction)};
}

// Where a ray meets a face's plane.
struct PlaneMeeting {
  float t;
  float inverse;  // how far the ray goes while it comes nearer to the plane by 1
};
[[nodiscard]] inline PlaneMeeting meet_plane(const FaceGroup& faces, std::size_t k,
                                             const Vec3f& origin, const Vec3f& direction) {
  Vec3f normal = faces.normal[k];
  const float inverse = 1 / dot(normal, direction);
  return {-dot(normal, origin - faces.corner[k]) * inverse, inverse};
}

// Whether that is inside of the face. The place relative to the corner and its distance from the
// plane are sums of a few products, none of which is larger than the ray's origin and the face are
// far from the scene's centre; the latter's error moves the meeting along the ray.
struct FaceVerdict {
  std::uint32_t is_inside;  // for certain
  std::uint32_t is_open;    // an edge is closer than rounding can tell
};
[[nodiscard]] inline FaceVerdict judge(const FaceGroup& faces, std::size_t k, const Vec3f& origin,
                                       const Vec3f& direction, PlaneMeeting meeting,
                                       RayDoubt doubt) {
  Vec3f place = origin - faces.corner[k] + meeting.t * direction;
  float inside = std::numeric_limits<float>::max();  // of the nearest edge
  for (std::size_t edge = 0; edge < 4; ++edge) {
    const float distance = dot(faces.inward[edge][k], place) + faces.distance[edge][k];
    inside = distance < inside ? distance : inside;
  }
  const float error = doubt.of_place + doubt.of_distance * std::abs(meeting.inverse);
  return {flag(inside > error), flag(inside >= -error) & flag(inside <= error)};
}

// What rays are known to meet.
struct FaceLanes {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  Lanes<float> t;
  Lanes<std::uint32_t> face;
  // The nearest place where a ray passes an edge of a face closer than rounding can tell: before
  // `t` it is open what the ray meets.
  Lanes<float> open_t;
};

// The nearest faces that the rays of a block meet for certain.
[[nodiscard]] FaceLanes find_nearest_faces(const FaceGroups& faces, const RayBlock& rays);

struct NearestFace {
  float t;
  std::uint32_t face;
  bool is_open;
};
// The same of one ray.
[[nodiscard]] NearestFace find_nearest_face(const FaceGroups& faces, const Ray& ray);

[[nodiscard]] LaneMask open_lanes(const FaceLanes& nearest);
[[nodiscard]] LaneMask lanes_with_face(const FaceLanes& nearest);

}  // namespace candela
