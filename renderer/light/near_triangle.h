// Points on triangles, uniform in solid angle (renderer/sampling/spherical_triangle.h) and warped
// by the cosine. By area where the triangle is far or seen edge on.
#pragma once

#include "renderer/light/near_place.h"

namespace candela {

[[nodiscard]] NearPlace sample_near_triangle(const Light& light, const Vec3f& from,
                                             const Vec3f& normal, Vec2f u);
[[nodiscard]] float near_triangle_pdf(const Light& light, const Vec3f& from, const Vec3f& normal,
                                      const Vec3f& wi, float distance);

}  // namespace candela
