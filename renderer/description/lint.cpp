#include <fmt/format.h>

#include "renderer/description/used_materials.h"
#include "renderer/description/validate.h"
#include "renderer/description/validate_light.h"
#include "renderer/description/world_bounds.h"

namespace candela::description {
namespace {

// Of the scene file's own: libraries (MTL) usually hold more than a scene needs.
void warn_of_unused_materials(const SceneDescription& scene, Diagnostics& diagnostics) {
  const std::vector<bool> is_used = used_materials(scene);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& material = scene.materials[i];
    const bool is_own = material.span.file && *material.span.file == scene.path;
    if (!is_used[i] && is_own)
      diagnostics.warning(material.span,
                          fmt::format("material '{}' is used by no model", material.name));
  }
}

void warn_of_black_lights(const SceneDescription& scene, Diagnostics& diagnostics) {
  for (const Light& light : scene.lights)
    if (is_black(light) && !std::holds_alternative<ConstantEnvironment>(light.kind))
      diagnostics.warning(light.span, "this light is black");
}

// All of the scene's box lies behind the camera's plane.
void warn_of_blind_cameras(const SceneDescription& scene, Diagnostics& diagnostics) {
  const Bounds3d box = world_bounds(scene);
  if (box.is_empty()) return;
  for (const Camera& camera : scene.cameras) {
    if (camera.kind == CameraKind::LatLong || camera.kind == CameraKind::EqualArea) continue;
    const Vec3d sight = camera.target - camera.eye;
    const Vec3d look = sight / max_component(glm::abs(sight));  // of which no product vanishes
    Vec3d farthest;  // the box's corner that lies most in the direction of sight
    for (int axis = 0; axis < 3; ++axis)
      farthest[axis] = look[axis] > 0 ? box.upper[axis] : box.lower[axis];
    const Vec3d towards = farthest - camera.eye;
    const double size = max_component(glm::abs(towards));
    if (!(size > 0) || dot(towards / size, look) <= 0)
      diagnostics.warning(camera.span, "all of the scene lies behind this camera");
  }
}

}  // namespace

Diagnostics lint(const SceneDescription& scene) {
  Diagnostics diagnostics;
  warn_of_unused_materials(scene, diagnostics);
  warn_of_black_lights(scene, diagnostics);
  warn_of_blind_cameras(scene, diagnostics);
  return diagnostics;
}

}  // namespace candela::description
