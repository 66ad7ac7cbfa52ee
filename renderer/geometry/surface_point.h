// Hit -> SurfacePoint: where a ray met the scene, with a bound of the position's rounding error,
// the geometric normal and the shading frame. Fixed once a hit; materials and integrators only read
// it.
#pragma once

#include <cstdint>
#include <limits>

#include "renderer/geometry/geometry.h"
#include "renderer/math/constants.h"
#include "renderer/math/float4.h"
#include "renderer/math/frame.h"
#include "renderer/math/ray.h"
#include "renderer/math/vec.h"

namespace candela {

struct SurfacePoint {
  Vec3f position{0};
  float offset = 0;  // bound of the position's error along the geometric normal, >= 0
  Vec3f geometric_normal{0, 0, 1};  // unit, on the side of wo
  bool is_front = true;             // wo is on the side that the winding calls outside
  bool is_flat = true;              // the front normal is the geometric one
  Vec3f front_normal{0, 0, 1};      // unit shading normal as the file has it, on the front side
  Frame shading;                    // z on the side of wo; set by set_shading_frame
  // The shading normal where light is received on its side alone, by the cosine; else, as within
  // media, zero.
  Vec3f receiving_normal{0};
  Vec2f uv{0.5f, 0.5f};
  Vec3f dpdu{0};  // world space, not normalised; zero where uv is degenerate or nothing reads it
  Vec3f dpdv{0};
};

namespace surface_point_detail {

struct Corners {
  Vec3f p0, p1, p2;
};

// In the object's space.
[[nodiscard]] inline Corners corners_of(const Geometry& geometry, std::uint32_t triangle) {
  const auto& index = geometry.triangles[triangle];
  return {geometry.positions[index[0]], geometry.positions[index[1]], geometry.positions[index[2]]};
}

// Where a ray met a triangle, whatever its sides are.
template <class V>
struct PlanePoint {
  V position;
  V normal;      // unit, of e1 x e2
  float offset;  // see SurfacePoint
};

// Bound of how far a point interpolated from barycentrics may lie from the triangle's plane, and of
// how wrong an intersector may be about that plane nearby: rounding of the interpolation
// [Pharr23, section 6.8.5], and of products of edges as long as the triangle. Per axis.
template <class V>
[[nodiscard]] inline V interpolation_error(V p0, V p1, V p2, float b0, float b1, float b2, V e1,
                                           V e2) {
  V magnitude = absolute(p0) * b0 + absolute(p1) * b1 + absolute(p2) * b2;
  const float longest = largest3(max(absolute(e1), absolute(e2)));
  return magnitude * gamma_bound(7) + longest * gamma_bound(8);
}

// V: the lanes of one triangle's vectors, or, in loops over paths, plain vectors.
template <class V>
[[nodiscard]] inline PlanePoint<V> plane_point(V p0, V p1, V p2, float u, float v) {
  const float b0 = 1 - u - v;
  V e1 = p1 - p0;
  V e2 = p2 - p0;
  V error = interpolation_error(p0, p1, p2, std::abs(b0), u, v, e1, e2);
  V perpendicular = cross3(e1, e2);
  float length2 = dot3(perpendicular, perpendicular);
  if (!(length2 <= std::numeric_limits<float>::max())) {  // of edges from 4e9 on
    perpendicular = perpendicular * 0x1p-62f;
    length2 = dot3(perpendicular, perpendicular);
  }
  V normal = perpendicular * (1 / std::sqrt(length2));
  return {p0 * b0 + p1 * u + p2 * v, normal, dot3(absolute(normal), error)};
}

// The same in the world, of a point in the object's space. Not by placed corners: far from the
// world's origin those of a small triangle round together. The normal points to where the winding
// calls outside, of a mirrored instance, too.
[[nodiscard]] inline PlanePoint<Vec3f> placed_point(const Instance& instance,
                                                    const PlanePoint<Vec3f>& own) {
  const Vec3f outside = normalize(instance.normal(own.normal));
  const float scale = std::abs(dot(outside, instance.vector(own.normal)));  // of planes' distances
  return {instance.point(own.position), outside, own.offset * scale + instance.offset(outside)};
}

// `n`: interpolated, of any length; the triangle's own where it is zero.
inline void set_front_normal(const Vec3f& n, SurfacePoint& point) {
  const float length2 = dot(n, n);
  if (!(length2 > 0)) return;
  point.front_normal = n / std::sqrt(length2);
  point.is_flat = false;
}

}  // namespace surface_point_detail

[[nodiscard]] inline float least_mirror_height(float geometric_wo) {
  return std::min(0.9f * geometric_wo, 0.01f);
}

// Whether a shading normal needs no bending, by cosines between: it and wo, both normals, wo and
// the geometric normal. The mirror direction about it has a height above the surface.
[[nodiscard]] inline bool is_unbent(float shading_wo, float shading_geometric, float geometric_wo) {
  const float height = 2 * shading_wo * shading_geometric - geometric_wo;
  return height >= least_mirror_height(geometric_wo);
}

// The shading normal, bent towards the geometric one just as far as the mirror direction about it
// needs to stay above the surface: no black silhouettes, no light through. All vectors unit, the
// geometric normal on the side of wo.
//
// In the plane of both normals a normal at the angle a from the geometric one mirrors wo to the
// height x sin 2a + z cos 2a, where (x, z) is what of wo lies in that plane: of length r and at the
// angle b from the geometric normal, r cos(2a - b). So the steepest a that still gives the height h
// has 2a = b + acos(h / r).
[[nodiscard]] inline Vec3f valid_shading_normal(const Vec3f& shading, const Vec3f& geometric,
                                                const Vec3f& wo) {
  const float z = dot(geometric, wo);
  if (is_unbent(dot(shading, wo), dot(shading, geometric), z)) return shading;
  Vec3f aside = shading - geometric * dot(shading, geometric);
  const float length2 = dot(aside, aside);
  if (!(length2 > 0)) return geometric;
  Vec3f tangent = aside / std::sqrt(length2);
  const float x = dot(tangent, wo);
  const float r = std::sqrt(x * x + z * z);
  if (!(r > 0)) return geometric;
  const float cosine = least_mirror_height(z) / r;
  const float sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
  Vec3f doubled =
      tangent * ((x * cosine + z * sine) / r) + geometric * ((z * cosine - x * sine) / r);
  Vec3f halfway = geometric + doubled;
  const float halfway2 = dot(halfway, halfway);
  return halfway2 > 0 ? halfway / std::sqrt(halfway2) : geometric;
}

// Of a triangle with texture coordinates. `instance` may be null.
inline void set_tangents(const Geometry& geometry, const TriangleCorners& corners,
                         const Instance* instance, SurfacePoint& point) {
  Vec2f d1 = geometry.uvs[corners[1]] - geometry.uvs[corners[0]];
  Vec2f d2 = geometry.uvs[corners[2]] - geometry.uvs[corners[0]];
  const float determinant = difference_of_products(d1.x, d2.y, d1.y, d2.x);
  if (determinant == 0) return;
  const Vec3f& p0 = geometry.positions[corners[0]];
  const auto edge_to = [&](std::uint32_t corner) {
    const Vec3f edge = geometry.positions[corner] - p0;
    return to_lanes(instance != nullptr ? instance->vector(edge) : edge);
  };
  const Float4 edge1 = edge_to(corners[1]);
  const Float4 edge2 = edge_to(corners[2]);
  point.dpdu = to_vec3(edge1 * d2.y - edge2 * d1.y) / determinant;
  point.dpdv = to_vec3(edge2 * d1.x - edge1 * d2.x) / determinant;
}

// All but the shading frame. `instance` may be null. With `with_uv` false, uv and its derivatives
// stay at their defaults.
[[nodiscard]] inline SurfacePoint make_triangle_point(const Geometry& geometry,
                                                      const Instance* instance, const Hit& hit,
                                                      const Vec3f& wo, bool with_uv) {
  using namespace surface_point_detail;
  const Corners c = corners_of(geometry, hit.triangle);
  const auto& index = geometry.triangles[hit.triangle];
  const float b0 = 1 - hit.u - hit.v;
  const PlanePoint<Float4> own =
      plane_point(to_lanes(c.p0), to_lanes(c.p1), to_lanes(c.p2), hit.u, hit.v);
  PlanePoint<Vec3f> plane{to_vec3(own.position), to_vec3(own.normal), own.offset};
  if (instance != nullptr) plane = placed_point(*instance, plane);

  SurfacePoint point;
  point.position = plane.position;
  point.offset = plane.offset;
  const Vec3f outside = plane.normal;
  point.is_front = dot(outside, wo) > 0;
  point.geometric_normal = point.is_front ? outside : -outside;

  point.front_normal = outside;
  if (!geometry.normals.empty()) {
    Vec3f n = geometry.normals[index[0]] * b0 + geometry.normals[index[1]] * hit.u +
              geometry.normals[index[2]] * hit.v;
    if (instance != nullptr) n = instance->normal(n);
    set_front_normal(n, point);
  }
  if (with_uv && !geometry.uvs.empty()) {
    point.uv = uv_of(geometry, index, hit.u, hit.v);
    if (geometry.reads_tangents) set_tangents(geometry, index, instance, point);
  }
  return point;
}

// The same of a sphere. By value: what kernels hold in registers must not have an address.
[[nodiscard]] SurfacePoint make_sphere_point(const Sphere& sphere, const Instance* instance,
                                             Hit hit, Vec3f wo, bool with_uv);

// Of either.
[[nodiscard]] inline SurfacePoint make_surface_point(const Geometry& geometry,
                                                     const Instance* instance, const Hit& hit,
                                                     const Vec3f& wo, bool with_uv) {
  if (!geometry.spheres.empty()) [[unlikely]]
    return make_sphere_point(geometry.spheres[hit.triangle], instance, hit, wo, with_uv);
  return make_triangle_point(geometry, instance, hit, wo, with_uv);
}

// Fixes the shading frame from the front normal, on the side of wo and bent as far as it must be.
inline void set_shading_frame(SurfacePoint& point, const Vec3f& wo) {
  if (point.is_flat) {
    point.shading = frame_from_normal(point.geometric_normal);
    return;
  }
  const Vec3f& front = point.front_normal;
  Vec3f facing = dot(front, point.geometric_normal) < 0 ? -front : front;
  point.shading = frame_from_normal(valid_shading_normal(facing, point.geometric_normal, wo));
}

// The start of a ray that leaves a surface towards `direction`: moved off it by the bound of the
// position's error, so that the ray cannot meet the surface it left [Pharr23, section 6.8.6].
[[nodiscard]] inline Vec3f offset_origin(const Vec3f& position, const Vec3f& normal, float offset,
                                         const Vec3f& direction) {
  return position + normal * std::copysign(offset, dot(direction, normal));
}

[[nodiscard]] inline Ray spawn_ray(const SurfacePoint& point, const Vec3f& direction) {
  return {offset_origin(point.position, point.geometric_normal, point.offset, direction), direction,
          infinity};
}

}  // namespace candela
