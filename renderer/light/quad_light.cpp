#include "renderer/light/quad_light.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "renderer/math/float4.h"
#include "renderer/sampling/bilinear.h"
#include "renderer/sampling/spherical_rectangle.h"

namespace candela {
namespace {

// Below this area is as good: from near by that is an edge-on view.
constexpr float least_solid_angle = 0.01f;
// Of the warp, and of the largest of its weights.
constexpr float least_weight = 0.05f;
constexpr float least_share = 0.1f;

Float4 square_root(Float4 x) {
#if defined(__SSE2__)
  return _mm_sqrt_ps(x);
#else
  return Float4{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
#endif
}

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

// The receiver's cosines towards the corners, none of them far below the others: within the
// rectangle they may be larger. Nothing where all of it is below the receiver's horizon.
std::optional<BilinearDensity> cosine_warp(const Light& light, const Vec3f& from,
                                           const Vec3f& normal) {
  if (normal == Vec3f(0)) return BilinearDensity{};
  const Vec3f corner = light.position - from;
  const auto along = [&](int axis) {
    const float edge1 = light.edge1[axis];
    const float edge2 = light.edge2[axis];
    return corner[axis] + Float4{0, edge1, edge2, edge1 + edge2};
  };
  const Float4 x = along(0);
  const Float4 y = along(1);
  const Float4 z = along(2);
  const Float4 height = x * normal.x + y * normal.y + z * normal.z;
  const Float4 distance2 = x * x + y * y + z * z;  // 0 where the receiver touches a corner
  const Float4 cosine =
      height / square_root(max(distance2, broadcast(std::numeric_limits<float>::min())));
  const float most = std::max(std::max(cosine[0], cosine[1]), std::max(cosine[2], cosine[3]));
  if (!(most > 0)) return std::nullopt;
  const float least = std::max(least_weight, least_share * most);
  return BilinearDensity{std::max(least, cosine[0]), std::max(least, cosine[1]),
                         std::max(least, cosine[2]), std::max(least, cosine[3])};
}

}  // namespace

NearQuadSample sample_near_place(const Light& light, const Vec3f& from, const Vec3f& normal,
                                 Vec2f u) {
  const std::optional<BilinearDensity> warp = cosine_warp(light, from, normal);
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

float near_quad_pdf(const Light& light, const Vec3f& from, const Vec3f& normal, const Vec3f& wi,
                    float distance) {
  const std::optional<BilinearDensity> warp = cosine_warp(light, from, normal);
  if (!warp) return 0;
  const SeenQuad quad = seen_from(light, from);
  const SphericalRectangle& rectangle = quad.rectangle;
  if (!(rectangle.solid_angle > least_solid_angle)) return triangle_light_pdf(light, wi, distance);
  const Vec3d point = Vec3d(wi) * static_cast<double>(distance);
  const Vec2f place = rectangle.place_of({dot(point, quad.axis1), dot(point, quad.axis2)});
  return warp->at(place) / rectangle.solid_angle;
}

}  // namespace candela
