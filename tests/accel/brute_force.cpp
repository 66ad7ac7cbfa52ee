#include "tests/accel/brute_force.h"

#include <fmt/format.h>

#include "renderer/base/floating_point_traps.h"

namespace candela::test {
namespace {

struct ClearHit {
  Hit hit;
  ExactHit exact;
};

bool is_clear(const ExactHit& exact, const Ray& ray) {
  return std::min({exact.u, exact.v, 1 - exact.u - exact.v}) > exact.weight_error &&
         exact.t > exact.t_error && exact.t < static_cast<double>(ray.t_max) - exact.t_error;
}

// Embree's boxes round in units of the origin (compare_hits.cpp).
double box_error(const Ray& ray) {
  return 0x1p-21 * length(Vec3d(ray.origin));
}

void visit(const Scene& scene, const Ray& ray, const Object& object, std::uint32_t instance,
           std::optional<ClearHit>& nearest) {
  for (const GeometryHandle geometry : object.geometries) {
    const std::size_t count = scene.geometries[geometry.index].triangles.size();
    for (std::uint32_t i = 0; i < count; ++i) {
      const Hit hit{.geometry = geometry.index, .triangle = i, .instance = instance};
      const ExactHit exact = intersect_exactly(scene, ray, hit, box_error(ray));
      if (is_clear(exact, ray) && (!nearest || exact.t < nearest->exact.t))
        nearest = ClearHit{hit, exact};
    }
  }
}

std::optional<ClearHit> nearest_clear_hit(const Scene& scene, const Ray& ray) {
  const FloatingPointTraps traps(Traps::Off);  // rays along a plane have no weights in it
  std::optional<ClearHit> nearest;
  visit(scene, ray, scene.world, Hit{}.instance, nearest);
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i)
    visit(scene, ray, scene.objects[scene.instances[i].object.index], i, nearest);
  return nearest;
}

std::string hit_complaint(const Scene& scene, const Ray& ray, const Hit& hit) {
  const ExactHit exact = intersect_exactly(scene, ray, hit);
  if (exact.t_error == std::numeric_limits<double>::infinity()) return "";
  const double smallest = std::min({exact.u, exact.v, 1 - exact.u - exact.v});
  if (smallest < -exact.weight_error)
    return fmt::format("triangle {} is missed by {} (error {})", hit.triangle, smallest,
                       exact.weight_error);
  if (std::abs(exact.t - static_cast<double>(hit.t)) > exact.t_error)
    return fmt::format("t is {}, not {} (error {})", exact.t, hit.t, exact.t_error);
  if (std::abs(exact.u - static_cast<double>(hit.u)) > exact.weight_error ||
      std::abs(exact.v - static_cast<double>(hit.v)) > exact.weight_error)
    return fmt::format("weights are {} {}, not {} {} (error {})", exact.u, exact.v, hit.u, hit.v,
                       exact.weight_error);
  if (!(hit.t >= 0) || hit.t > ray.t_max) return fmt::format("t = {} is out of range", hit.t);
  return "";
}

}  // namespace

std::string brute_force_complaint(const Scene& scene, const Ray& ray, const Hit& answer) {
  const std::optional<ClearHit> nearest = nearest_clear_hit(scene, ray);
  if (nearest && (!answer.is_hit() || static_cast<double>(answer.t) >
                                          nearest->exact.t + nearest->exact.t_error +
                                              intersect_exactly(scene, ray, answer).t_error))
    return fmt::format("triangle {} at {} (error {}) lies nearer than {}", nearest->hit.triangle,
                       nearest->exact.t, nearest->exact.t_error, answer.t);
  return answer.is_hit() ? hit_complaint(scene, ray, answer) : "";
}

}  // namespace candela::test
