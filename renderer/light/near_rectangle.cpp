#include "renderer/light/near_rectangle.h"

#include "renderer/light/cosine_warp.h"
#include "renderer/sampling/spherical_rectangle.h"

namespace candela {
namespace {

// Below this area is as good: from near by that is an edge-on view.
constexpr float least_solid_angle = 0.01f;
// A quad in its own axes, with the receiver above the origin.
struct SeenQuad {
  Vec3d axis1, axis2;
  SphericalRectangle rectangle;
};

SeenQuad seen_from(const Light& light, const Vec3f& from) {
  const auto length1 = static_cast<double>(light.length1);
  const auto length2 = static_cast<double>(light.length2);
  const Vec3d axis1 = Vec3d(light.edge1) * (1 / length1);
  const Vec3d axis2 = Vec3d(light.edge2) * (1 / length2);
  const Vec3d corner(light.position - from);
  const double x = dot(corner, axis1);
  const double y = dot(corner, axis2);
  const double height = std::abs(dot(corner, Vec3d(light.normal)));
  return {axis1, axis2, make_spherical_rectangle(x, y, x + length1, y + length2, height)};
}

std::optional<BilinearDensity> warp_of(const Light& light, const Vec3f& from, const Vec3f& normal) {
  const Vec3f corner = light.position - from;
  const auto along = [&](int axis) {
    const float edge1 = light.edge1[axis];
    const float edge2 = light.edge2[axis];
    return corner[axis] + Float4{0, edge1, edge2, edge1 + edge2};
  };
  return cosine_warp({along(0), along(1), along(2)}, normal);
}

}  // namespace

NearPlace sample_near_rectangle(const Light& light, const Vec3f& from, const Vec3f& normal,
                                Vec2f u) {
  const std::optional<BilinearDensity> warp = warp_of(light, from, normal);
  if (!warp) return {.is_seen = false};
  const SeenQuad quad = seen_from(light, from);
  const SphericalRectangle& rectangle = quad.rectangle;
  if (!(rectangle.solid_angle > least_solid_angle)) return {.weights = u};
  const Vec2f warped = warp->sample(u);
  const Vec2d point = rectangle.point(warped);
  return {.weights = {static_cast<float>(point.x - rectangle.x0) / light.length1,
                      static_cast<float>(point.y - rectangle.y0) / light.length2},
          .pdf = warp->at(warped) / rectangle.solid_angle};
}

float near_rectangle_pdf(const Light& light, const Vec3f& from, const Vec3f& normal,
                         const Vec3f& wi, float distance) {
  const std::optional<BilinearDensity> warp = warp_of(light, from, normal);
  if (!warp) return 0;
  const SeenQuad quad = seen_from(light, from);
  const SphericalRectangle& rectangle = quad.rectangle;
  if (!(rectangle.solid_angle > least_solid_angle)) return triangle_light_pdf(light, wi, distance);
  const Vec3d point = Vec3d(wi) * static_cast<double>(distance);
  const Vec2f place = rectangle.place_of({dot(point, quad.axis1), dot(point, quad.axis2)});
  return warp->at(place) / rectangle.solid_angle;
}

}  // namespace candela
