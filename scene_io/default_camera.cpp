#include "scene_io/default_camera.h"

#include <cmath>

#include "renderer/description/world_bounds.h"
#include "renderer/math/constants.h"

namespace candela {

description::Camera default_camera(const description::SceneDescription& scene) {
  description::Camera camera;
  const Bounds3d bounds = description::world_bounds(scene);
  if (bounds.is_empty()) return camera;
  constexpr double fovy_degrees = 45;
  const double radius = 0.5 * length(bounds.extent());
  // The sphere about the bounds touches the picture's upper and lower edge.
  const double distance = radius / std::sin(0.5 * fovy_degrees * (pi_double / 180));
  const Vec3d towards_eye = normalize(Vec3d(0, 0.25, 1));
  camera.fovy_degrees = fovy_degrees;
  camera.target = bounds.centre();
  camera.eye = camera.target + towards_eye * (radius > 0 ? distance : 1);
  return camera;
}

}  // namespace candela
