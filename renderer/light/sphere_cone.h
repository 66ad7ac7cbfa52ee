// Directions towards a sphere from outside: uniform in the cone in which it is seen [Pharr23,
// section 6.2.4]. In double: near the sphere the cosine cancels, far from it 1 - cosine would.
#pragma once

#include "renderer/light/light.h"
#include "renderer/light/shadow_segment.h"
#include "renderer/math/frame.h"
#include "renderer/math/transcendental.h"

namespace candela {

[[nodiscard]] inline double radius_of(const Light& sphere) {
  return static_cast<double>(sphere.edge1.x);
}

// To its centre from where rays towards it start, as those that meet it see it
// (sphere_light_pdf()): close to the sphere both are within or none is.
[[nodiscard]] inline Vec3d to_centre_of(const Light& sphere, const SurfacePoint& from) {
  return Vec3d(sphere.position) -
         Vec3d(offset_origin(from.position, from.geometric_normal, from.offset,
                             sphere.position - from.position));
}

// Whether a point so far from the sphere's centre lies within it or, to the rounding of positions,
// on it: such points see nothing of its outside.
[[nodiscard]] inline bool is_within(const Light& sphere, double distance2) {
  return distance2 <= square(radius_of(sphere) + 4 * static_cast<double>(sphere.offset));
}

// As seen from `distance2` (squared) from the centre.
struct SphereCone {
  double sine2;    // of the half angle
  double versine;  // 1 - cosine

  SphereCone(double radius, double distance2) {
    const double radius2 = square(radius);
    sine2 = radius2 / distance2;
    versine = sine2 / (1 + std::sqrt((distance2 - radius2) / distance2));
  }
  [[nodiscard]] float pdf() const { return static_cast<float>(1 / (2 * pi_double * versine)); }
};

struct ConeSample {
  Vec3f wi;
  Vec3f direction;  // from the centre to where wi meets the sphere
  float pdf;        // in solid angle of wi
};

// A direction at the angle theta from the axis meets the sphere at the angle alpha from the axis as
// its centre sees it [Pharr23, eq. 6.20], where sine2 of theta is `share` of the cone's.
[[nodiscard]] inline ConeSample sample_sphere_cone(double radius, const Vec3d& to_centre,
                                                   double distance2, Vec2f u) {
  const SphereCone cone(radius, distance2);
  const double versine = static_cast<double>(u.x) * cone.versine;
  const double sine2 = versine * (2 - versine);
  const double share = std::min(1.0, sine2 / cone.sine2);
  const double cosine_to_surface = std::sqrt(1 - share);  // of the angle at the point met
  const double sine_alpha =
      std::sqrt(share) * (1 - versine - std::sqrt(cone.sine2) * cosine_to_surface);
  const double cosine_alpha = std::sqrt(cone.sine2) * share + (1 - versine) * cosine_to_surface;
  Frame frame = frame_from_normal(Vec3f(to_centre / std::sqrt(distance2)));
  SinCos azimuth = sin_cos_of_turns(u.y);
  Vec3f across = frame.x * azimuth.cos + frame.y * azimuth.sin;
  Vec3f wi = normalize(frame.z * static_cast<float>(1 - versine) +
                       across * static_cast<float>(std::sqrt(sine2)));
  Vec3f direction = normalize(across * static_cast<float>(sine_alpha) -
                              frame.z * static_cast<float>(cosine_alpha));
  return {wi, direction, cone.pdf()};
}

// The radiance that a sphere without an image emits in `direction` from its centre towards `wo`.
[[nodiscard]] inline Rgb plain_sphere_radiance(const Light& sphere, const Vec3f& direction,
                                               const Vec3f& wo) {
  const bool is_outside = dot(direction, wo) > 0;
  return sphere.emits_both_sides || is_outside != sphere.faces_inwards ? sphere.emission : Rgb(0);
}

// From a point of the sphere in `direction` from its centre.
[[nodiscard]] inline Ray shadow_segment_to_sphere(const Light& sphere, const SurfacePoint& from,
                                                  const Vec3f& direction, const Vec3f& wi) {
  Vec3f point = sphere.position + direction * sphere.edge1.x;
  return shadow_segment(from, wi, offset_origin(point, direction, sphere.offset, -wi));
}

}  // namespace candela
