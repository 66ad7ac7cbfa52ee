#include "scene_io/default_camera.h"

#include <cmath>
#include <memory>
#include <string>

#include "renderer/description/world_bounds.h"
#include "renderer/math/constants.h"
#include "renderer/math/near_one.h"

namespace candela {
namespace {

// Of coordinates whose squares may be no number or 0, too.
double length_of(const Vec3d& v) {
  if (v == Vec3d(0.0)) return 0;
  return std::ldexp(length(near_one(v)), exponent_of(v));
}

}  // namespace

description::Camera default_camera(const description::SceneDescription& scene) {
  description::Camera camera;
  if (!scene.path.empty()) camera.span = {std::make_shared<const std::string>(scene.path), 0, 0};
  const Bounds3d bounds = description::world_bounds(scene);
  if (bounds.is_empty()) return camera;
  constexpr double fovy_degrees = 45;
  const double radius = 0.5 * length_of(bounds.extent());
  // The sphere about the bounds touches the picture's upper and lower edge.
  const double distance = radius / std::sin(0.5 * fovy_degrees * (pi_double / 180));
  const Vec3d towards_eye = normalize(Vec3d(0, 0.25, 1));
  camera.fovy_degrees = fovy_degrees;
  camera.target = bounds.centre();
  camera.eye = camera.target + towards_eye * (radius > 0 ? distance : 1);
  return camera;
}

}  // namespace candela
