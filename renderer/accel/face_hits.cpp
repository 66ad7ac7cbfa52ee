#include "renderer/accel/face_hits.h"

#include "renderer/base/vector_widths.h"

namespace candela {
namespace {

// With barycentrics as they come, which rounding may leave a little outside of the triangle.
[[gnu::always_inline]] inline Hit loose_hit(const FaceTriangles& triangles, const Ray& ray,
                                            float t) {
  const Vec3f place = ray.origin - triangles.corner + t * ray.direction;
  alignas(16) std::array<float, 4> barycentrics;
  for (std::size_t i = 0; i < 4; ++i)
    barycentrics[i] = triangles.x[i] * place.x + triangles.y[i] * place.y +
                      triangles.z[i] * place.z + triangles.at_corner[i];
  const std::size_t which = dot(triangles.across, place) >= 0 ? 0 : 1;
  return {.t = t,
          .u = barycentrics[2 * which],
          .v = barycentrics[2 * which + 1],
          .geometry = triangles.geometry[which],
          .triangle = triangles.triangle[which]};
}

// A loop over lanes takes these for vector code, and std::clamp not.
[[gnu::always_inline]] inline void keep_inside(float& u, float& v) {
  u = u < 0 ? 0 : u;
  u = u > 1 ? 1 : u;
  v = v < 0 ? 0 : v;
  v = v > 1 - u ? 1 - u : v;
}

}  // namespace

Hit hit_of(const FaceTriangles& triangles, const Ray& ray, float t) {
  Hit hit = loose_hit(triangles, ray, t);
  keep_inside(hit.u, hit.v);
  return hit;
}

CANDELA_LANES void set_hits(const std::vector<FaceTriangles>& triangles, const RayBlock& rays,
                            const FaceLanes& nearest, LaneMask lanes, HitBlock& hits) {
  for_each_lane(lanes, [&](std::uint32_t i) {
    const Hit hit = loose_hit(triangles[nearest.face[i]], rays[i], nearest.t[i]);
    hits.t[i] = hit.t;
    hits.u[i] = hit.u;
    hits.v[i] = hit.v;
    hits.geometry[i] = hit.geometry;
    hits.triangle[i] = hit.triangle;
  });
  for (std::size_t i = 0; i < block_size; ++i) keep_inside(hits.u[i], hits.v[i]);
  hits.met = lanes;
}

}  // namespace candela
