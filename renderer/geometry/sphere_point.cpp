#include "renderer/geometry/surface_point.h"

namespace candela {
namespace {

// Per axis: the unit direction's length, the product and the sum round [Pharr23, section 6.8.5].
Vec3f position_error(const Sphere& sphere, const Vec3f& direction) {
  return gamma_bound(8) * (glm::abs(sphere.centre) + glm::abs(direction) * sphere.radius);
}

// How far along the world's unit normal errors within the object move a placed point.
float placed_error(const Instance& instance, const Vec3f& normal, const Vec3f& error) {
  return dot(error, glm::abs(Vec3f(dot(normal, instance.x), dot(normal, instance.y),
                                   dot(normal, instance.z))));
}

struct Derivatives {
  Vec3f dpdu, dpdv;
};

// [Pharr23, section 6.2.3] with v downwards from pi. The azimuth at a pole is 0.
Derivatives derivatives_of(const Sphere& sphere, const Vec3f& direction) {
  const Vec3f own = in_own_axes(sphere, direction);
  const float across = std::sqrt(own.x * own.x + own.y * own.y);
  const float cosine = across > 0 ? own.x / across : 1.0f;
  const float sine = across > 0 ? own.y / across : 0.0f;
  return {
      (sphere.y * own.x - sphere.x * own.y) * (two_pi * sphere.radius),
      (sphere.z * across - (sphere.x * cosine + sphere.y * sine) * own.z) * (pi * sphere.radius)};
}

}  // namespace

// Whatever the error of the direction, the point lies on the sphere to within position_error().
SurfacePoint make_sphere_point(const Sphere& sphere, const Instance* instance, Hit hit, Vec3f wo,
                               bool with_uv) {
  const Vec3f direction = from_octahedron({hit.u, hit.v});
  const Vec3f error = position_error(sphere, direction);
  SurfacePoint point;
  point.position = sphere.centre + direction * sphere.radius;
  point.offset = dot(error, glm::abs(direction));
  Vec3f outside = direction;
  if (instance != nullptr) {
    point.position = instance->point(point.position);
    outside = normalize(instance->normal(direction));
    point.offset = placed_error(*instance, outside, error) + instance->offset(outside);
  }
  if (sphere.faces_inwards) outside = -outside;
  point.is_front = dot(outside, wo) > 0;
  point.geometric_normal = point.is_front ? outside : -outside;
  point.front_normal = outside;
  if (!with_uv) return point;
  point.uv = sphere_uv(sphere, direction);
  const Derivatives derivatives = derivatives_of(sphere, direction);
  point.dpdu = instance != nullptr ? instance->vector(derivatives.dpdu) : derivatives.dpdu;
  point.dpdv = instance != nullptr ? instance->vector(derivatives.dpdv) : derivatives.dpdv;
  return point;
}

}  // namespace candela
