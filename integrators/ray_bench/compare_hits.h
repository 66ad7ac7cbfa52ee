// Whether two accelerators' answers for one ray agree, judged in double from the scene's own
// vertices with bounds of what rounding to float can do.
#pragma once

#include "renderer/geometry/geometry.h"
#include "renderer/math/ray.h"
#include "renderer/scene/scene.h"

namespace candela {

enum class Agreement : std::uint8_t {
  Same,          // both miss, or hit one primitive at one distance
  SameDistance,  // two primitives at one distance within float error: coplanar, or along an edge
  // One answer is nearer and the ray passes its triangle's edge, or ends at its plane, within float
  // error (or within it of a cut-out's edge): both answers are right for some rounding.
  AtTheEdge,
  Differs,  // one of them is wrong
};

[[nodiscard]] Agreement compare_hits(const Scene& scene, const Ray& ray, const Hit& a,
                                     const Hit& b);

// How a ray meets one triangle, in double, with bounds of the error that float arithmetic makes.
struct ExactHit {
  double t = 0;
  double u = 0;  // barycentric weights of vertices 1 and 2; the triangle may be missed
  double v = 0;
  double t_error = 0;       // infinite where the ray lies in the triangle's plane
  double weight_error = 0;  // of u, v and 1 - u - v
};
// extra_error: of positions, in units of length, beside what the ray-triangle tests make.
[[nodiscard]] ExactHit intersect_exactly(const Scene& scene, const Ray& ray, const Hit& hit,
                                         double extra_error = 0);

}  // namespace candela
