#include "renderer/light/near_place.h"

#include "renderer/light/near_rectangle.h"
#include "renderer/light/near_triangle.h"

namespace candela {

NearPlace sample_near_place(const Light& light, const Vec3f& from, const Vec3f& normal, Vec2f u) {
  if (light.kind == LightKind::Quad) return sample_near_rectangle(light, from, normal, u);
  return sample_near_triangle(light, from, normal, u);
}

float near_place_pdf(const Light& light, const Vec3f& from, const Vec3f& normal, const Vec3f& wi,
                     float distance) {
  if (light.kind == LightKind::Quad) return near_rectangle_pdf(light, from, normal, wi, distance);
  return near_triangle_pdf(light, from, normal, wi, distance);
}

}  // namespace candela
