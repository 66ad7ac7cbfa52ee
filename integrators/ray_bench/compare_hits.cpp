#include "integrators/ray_bench/compare_hits.h"

#include "renderer/accel/alpha_test.h"

#include "renderer/base/floating_point_traps.h"

namespace candela {
namespace {

constexpr double unit_roundoff = 0x1p-24;

// A bound of the factor before u |C||d||e| / (n.d) in the error of a weight. By the usual counting
// of roundings [Higham02, section 3.1] a triple product C x d . e of rounded differences is off by
// at most 8.3 u |C||d||e|, and the largest weight's test, U + V <= n.d, adds three of them, the
// last with |e| <= 2 |C| in the place of |C|: 33. The watertight test's sheared vertices are off
// by 8.5 u |C| and its edge functions by twice that.
constexpr double roundings = 40;

struct PlacedTriangle {
  Vec3d vertices[3];
  double position_error = 0;  // of the vertices relative to the ray, beside plain subtraction
};

double magnitude(const Instance& i) {
  return length(Vec3d(i.x)) + length(Vec3d(i.y)) + length(Vec3d(i.z));
}

// An instanced triangle is met in the object's space: the ray's origin is rounded there, which the
// placement carries back enlarged by its condition number.
PlacedTriangle placed_triangle(const Scene& scene, const Ray& ray, const Hit& hit) {
  const Geometry& geometry = scene.geometries[hit.geometry];
  PlacedTriangle triangle;
  for (std::size_t i = 0; i < 3; ++i)
    triangle.vertices[i] = Vec3d(geometry.positions[geometry.triangles[hit.triangle][i]]);
  if (!hit.is_instanced()) return triangle;
  const Instance& instance = scene.instances[hit.instance];
  const Mat3d linear(Vec3d(instance.x), Vec3d(instance.y), Vec3d(instance.z));
  const Mat3d inverse = glm::inverse(linear);
  const double condition =
      magnitude(instance) * (length(inverse[0]) + length(inverse[1]) + length(inverse[2]));
  double reach = length(Vec3d(ray.origin)) + length(Vec3d(instance.translation));
  for (Vec3d& vertex : triangle.vertices) {
    vertex = linear * vertex + Vec3d(instance.translation);
    reach = std::max(reach, length(vertex));
  }
  triangle.position_error = roundings * unit_roundoff * condition * reach;
  return triangle;
}

bool is_of_sphere(const Scene& scene, const Hit& hit) {
  return !scene.geometries[hit.geometry].spheres.empty();
}

// Both accelerators meet spheres by one function: what may differ is what boxes and the transforms
// of instances round, in the ray's origin by ulps of where it is. The farther from a limb the less
// that moves: hits change where the ray's distance from the centre, or t, is within it of a limit.
struct SphereMargins {
  double t_error = 0;
  bool is_at_limb = false;
};
SphereMargins sphere_margins(const Scene& scene, const Ray& ray, const Hit& hit) {
  const Sphere& sphere = scene.geometries[hit.geometry].spheres[hit.triangle];
  Vec3d centre(sphere.centre);
  double radius = sphere.radius;
  double condition = 1;
  if (hit.is_instanced()) {
    const Instance& instance = scene.instances[hit.instance];
    centre = Vec3d(instance.point(sphere.centre));
    radius *= length(Vec3d(instance.x));
    condition = 3;  // of a similarity, by the sum of its columns' lengths
  }
  const Vec3d to_centre = centre - Vec3d(ray.origin);
  const Vec3d direction(ray.direction);
  const double along = dot(to_centre, direction) / length(direction);
  const double beside = std::sqrt(std::max(0.0, dot(to_centre, to_centre) - along * along));
  const double error =
      roundings * unit_roundoff * condition * (length(Vec3d(ray.origin)) + length(centre) + radius);
  const double half_chord = std::sqrt(std::max(0.0, radius * radius - beside * beside));
  return {error * (1 + radius / std::max(half_chord, error)) / length(direction),
          beside + error >= radius};
}

bool is_near_zero(double value, double error) {
  return std::abs(value) <= error;
}

// Whether the cut-out decides otherwise somewhere within the error of (u, v).
bool is_at_cutout_edge(const Scene& scene, const Ray& ray, const Hit& hit, double error) {
  if (!scene.geometries[hit.geometry].has_cutouts) return false;
  for (const double du : {-error, error})
    for (const double dv : {-error, error})
      if (is_transparent_at(scene, hit.geometry, hit.triangle, hit.instance,
                            static_cast<float>(hit.u + du), static_cast<float>(hit.v + dv),
                            ray.origin, ray.direction))
        return true;
  return false;
}

// Whether rounding may decide whether this hit exists. Embree's fast test of boxes, plane/d - o/d,
// rounds in units of the origin itself: a triangle of a few ulps of the origin's coordinates may be
// lost with its box, however near.
bool is_marginal(const Scene& scene, const Ray& ray, const Hit& hit) {
  const FloatingPointTraps traps(Traps::Off);  // what divides by 0 is no number
  if (is_of_sphere(scene, hit)) {
    const SphereMargins margins = sphere_margins(scene, ray, hit);
    return margins.is_at_limb || is_near_zero(hit.t, margins.t_error) ||
           is_near_zero(static_cast<double>(hit.t) - static_cast<double>(ray.t_max),
                        margins.t_error) ||
           is_at_cutout_edge(scene, ray, hit, roundings * unit_roundoff);
  }
  const double box_error = 8 * unit_roundoff * length(Vec3d(ray.origin));
  const ExactHit exact = intersect_exactly(scene, ray, hit, box_error);
  if (exact.t_error == std::numeric_limits<double>::infinity()) return true;
  const double smallest = std::min({exact.u, exact.v, 1 - exact.u - exact.v});
  if (is_near_zero(smallest, exact.weight_error)) return true;
  if (is_near_zero(exact.t, exact.t_error)) return true;
  if (is_near_zero(exact.t - static_cast<double>(ray.t_max), exact.t_error)) return true;
  return is_at_cutout_edge(scene, ray, hit, exact.weight_error);
}

bool is_same_primitive(const Hit& a, const Hit& b) {
  return a.geometry == b.geometry && a.triangle == b.triangle && a.instance == b.instance;
}

}  // namespace

// With C the vertices relative to the origin, e the longest edge, n = e1 x e2 and d the direction:
// a weight is a triple product of size |C||d||e| over n.d, the distance one of size |C||e|^2.
ExactHit intersect_exactly(const Scene& scene, const Ray& ray, const Hit& hit, double extra_error) {
  const FloatingPointTraps traps(Traps::Off);  // rays along the plane divide by 0
  const PlacedTriangle triangle = placed_triangle(scene, ray, hit);
  const Vec3d direction(ray.direction);
  const Vec3d a = triangle.vertices[0] - Vec3d(ray.origin);
  const Vec3d b = triangle.vertices[1] - Vec3d(ray.origin);
  const Vec3d c = triangle.vertices[2] - Vec3d(ray.origin);
  const Vec3d normal = cross(b - a, c - a);
  const double denominator = dot(normal, direction);
  const double edge = std::max({length(b - a), length(c - a), length(c - b)});
  const double reach = std::max({length(a), length(b), length(c)});
  const double error = roundings * unit_roundoff * reach + triangle.position_error + extra_error;
  ExactHit exact;
  exact.t = dot(a, normal) / denominator;
  exact.u = dot(cross(c, a), direction) / denominator;
  exact.v = dot(cross(a, b), direction) / denominator;
  exact.t_error = error * edge * edge / std::abs(denominator);
  exact.weight_error = error * length(direction) * edge / std::abs(denominator);
  // A weight that may be all of one is no weight: the ray runs along the plane.
  if (!(exact.weight_error < 0.5)) exact.t_error = std::numeric_limits<double>::infinity();
  return exact;
}

namespace {

double error_of_t(const Scene& scene, const Ray& ray, const Hit& hit) {
  return is_of_sphere(scene, hit) ? sphere_margins(scene, ray, hit).t_error
                                  : intersect_exactly(scene, ray, hit).t_error;
}

}  // namespace

Agreement compare_hits(const Scene& scene, const Ray& ray, const Hit& a, const Hit& b) {
  if (!a.is_hit() && !b.is_hit()) return Agreement::Same;
  if (a.is_hit() && b.is_hit()) {
    const double gap = std::abs(static_cast<double>(a.t) - static_cast<double>(b.t));
    const double error = error_of_t(scene, ray, a);
    if (is_same_primitive(a, b) && gap <= error) return Agreement::Same;
    if (is_same_primitive(a, b)) return Agreement::Differs;
    if (gap <= error + error_of_t(scene, ray, b)) return Agreement::SameDistance;
  }
  const Hit& nearer = a.t < b.t ? a : b;
  return is_marginal(scene, ray, nearer) ? Agreement::AtTheEdge : Agreement::Differs;
}

}  // namespace candela
