#include "renderer/description/validate_medium.h"

#include <cmath>

#include <fmt/format.h>

namespace candela::description {
namespace {

void check_coefficient(const Medium& medium, const Vec3d& coefficient, std::string_view what,
                       Diagnostics& diagnostics) {
  for (int c = 0; c < 3; ++c) {
    if (coefficient[c] >= 0 && std::isfinite(coefficient[c])) continue;
    diagnostics.error(medium.span, fmt::format("medium '{}': {} is {}, expected at least 0",
                                               medium.name, what, coefficient[c]));
    return;
  }
}

void check_medium(const Medium& medium, Diagnostics& diagnostics) {
  check_coefficient(medium, medium.absorption, "the absorption", diagnostics);
  check_coefficient(medium, medium.scattering, "the scattering", diagnostics);
  if (!(medium.asymmetry > -1 && medium.asymmetry < 1))
    diagnostics.error(medium.span, fmt::format("medium '{}': the asymmetry is {}, expected above "
                                               "-1 and below 1",
                                               medium.name, medium.asymmetry));
}

bool exists(const SceneDescription& scene, MediumHandle medium) {
  return !medium || medium.index < scene.media.size();
}

}  // namespace

void check_media(const SceneDescription& scene, Diagnostics& diagnostics) {
  for (const Medium& medium : scene.media) check_medium(medium, diagnostics);
  for (const Material& material : scene.materials)
    if (!exists(scene, material.media.inside) || !exists(scene, material.media.outside))
      diagnostics.error(
          material.span,
          fmt::format("material '{}' bounds a medium that does not exist", material.name));
  for (const Camera& camera : scene.cameras)
    if (!exists(scene, camera.medium))
      diagnostics.error(camera.span, "a camera is in a medium that does not exist");
}

}  // namespace candela::description
