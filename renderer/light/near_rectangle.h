// Points on rectangles, uniform in solid angle [Urena13] and warped by the cosine. By area where
// the rectangle is seen nearly edge on.
#pragma once

#include "renderer/light/near_place.h"

namespace candela {

[[nodiscard]] NearPlace sample_near_rectangle(const Light& light, const Vec3f& from,
                                              const Vec3f& normal, Vec2f u);
[[nodiscard]] float near_rectangle_pdf(const Light& light, const Vec3f& from, const Vec3f& normal,
                                       const Vec3f& wi, float distance);

}  // namespace candela
