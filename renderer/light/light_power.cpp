#include "renderer/light/light_power.h"

#include "renderer/math/colour.h"

namespace candela {
namespace {

// The solid angle of the cone, weighted by the falloff: the smooth part counts half, since
// 3t^2 - 2t^3 of the cosine has the mean 1/2.
double spot_solid_angle(const Light& light) {
  const double inner = light.versine_inner;
  const double outer = light.versine_outer;
  return 2 * pi_double * (inner + 0.5 * (outer - inner));
}

}  // namespace

double light_power(const Light& light, const Environment* environment, double scene_radius) {
  const double disc = pi_double * square(scene_radius);
  const double emission = luminance(Vec3d(light.emission));
  const auto mean = static_cast<double>(light.mean_luminance);
  switch (light.kind) {
    case LightKind::Point:
      return 4 * pi_double * emission;
    case LightKind::Spot:
      return spot_solid_angle(light) * emission;
    case LightKind::Directional:
      return disc * emission;
    case LightKind::Triangle:
    case LightKind::Quad:
    case LightKind::NearTriangle:
      return (light.emits_both_sides ? 2 : 1) * pi_double * light.area * emission;
    case LightKind::Environment:
      return 4 * pi_double * disc * environment->mean_luminance;
    case LightKind::TexturedTriangle:
      return (light.emits_both_sides ? 2 : 1) * pi_double * light.area * mean;
    case LightKind::Sphere:
      return (light.emits_both_sides ? 2 : 1) * pi_double * light.area *
             (light.texture ? mean : emission);
    case LightKind::Goniometric:
    case LightKind::Projection:
      return 4 * pi_double * mean;
  }
  return 0;
}

}  // namespace candela
