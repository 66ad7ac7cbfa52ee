#include "renderer/description/validate_camera.h"

#include <cmath>

#include <fmt/format.h>

namespace candela::description {
namespace {

// Not zero; its squares may underflow.
Vec3d unit(const Vec3d& v) {
  return normalize(v / max_component(glm::abs(v)));
}

void check_axes(const Camera& camera, Diagnostics& diagnostics) {
  const Vec3d look = camera.target - camera.eye;
  if (look == Vec3d(0.0))
    diagnostics.error(camera.span, "a camera's eye and target are the same point");
  else if (camera.up == Vec3d(0.0))
    diagnostics.error(camera.span, "a camera's up direction is zero");
  else if (!(length(cross(unit(look), unit(camera.up))) > 1e-12))
    diagnostics.error(camera.span, "a camera's up direction is parallel to its line of sight");
}

bool sees_all_around(const Camera& camera) {
  return camera.kind == CameraKind::LatLong || camera.kind == CameraKind::EqualArea;
}

void check_window(const Camera& camera, Diagnostics& diagnostics) {
  if (!camera.screen_window) return;
  const ScreenWindow& w = *camera.screen_window;
  const double longest = 1e30;  // what numbers in files may be; differences stay finite
  const auto is_range = [&](double low, double high) {
    return low < high && std::abs(low) <= longest && std::abs(high) <= longest;
  };
  if (!is_range(w.left, w.right) || !is_range(w.bottom, w.top))
    diagnostics.error(camera.span,
                      fmt::format("a camera's screen window is {} to {} by {} to {}, expected "
                                  "left < right and bottom < top",
                                  w.left, w.right, w.bottom, w.top));
  if (sees_all_around(camera))
    diagnostics.error(camera.span, "a camera that sees all around has no screen window");
}

void check_camera(const Camera& camera, Diagnostics& diagnostics) {
  if (!is_finite(camera.eye) || !is_finite(camera.target) || !is_finite(camera.up))
    diagnostics.error(camera.span, "a camera has numbers that are not finite");
  else
    check_axes(camera, diagnostics);
  if (!(camera.fovy_degrees > 0 && camera.fovy_degrees < 180))
    diagnostics.error(camera.span,
                      fmt::format("a camera's vertical angle of view is {} degrees, expected above "
                                  "0 and below 180",
                                  camera.fovy_degrees));
  check_window(camera, diagnostics);
  if (sees_all_around(camera) && camera.lens_radius != 0)
    diagnostics.error(camera.span, "a camera that sees all around has no lens");
  if (!(camera.lens_radius >= 0 && std::isfinite(camera.lens_radius)))
    diagnostics.error(camera.span, fmt::format("a camera's lens radius is {}, expected at least 0",
                                               camera.lens_radius));
  if (!(camera.focus_distance >= 0 && std::isfinite(camera.focus_distance)))
    diagnostics.error(
        camera.span,
        fmt::format("a camera's focus distance is {}, expected at least 0", camera.focus_distance));
}

}  // namespace

void check_cameras(const SceneDescription& scene, Diagnostics& diagnostics) {
  if (scene.cameras.empty()) diagnostics.error({}, "the scene has no camera");
  for (const Camera& camera : scene.cameras) check_camera(camera, diagnostics);
}

}  // namespace candela::description
