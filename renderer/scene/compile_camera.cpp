#include "renderer/scene/compile_camera.h"

namespace candela {
namespace {

using description::ScreenWindow;

// The picture's part of the image plane (ScreenWindow), in units of what its angle of view, or 1
// for orthographic cameras, gives half of a side.
ScreenWindow window_of(const description::Camera& camera, double aspect) {
  if (camera.screen_window) return *camera.screen_window;
  if (camera.fov_is_of_shorter_side && aspect < 1) return {-1, 1, -1 / aspect, 1 / aspect};
  return {-aspect, aspect, -1, 1};
}

void set_window(const description::Camera& camera, const Vec3d& right, const Vec3d& up,
                double half_side, double aspect, Camera& out, Vec3d& middle) {
  const ScreenWindow window = window_of(camera, aspect);
  middle += right * (half_side * (0.5 * (window.left + window.right))) +
            up * (half_side * (0.5 * (window.bottom + window.top)));
  out.right = Vec3f(right * (half_side * (0.5 * (window.right - window.left))));
  out.up = Vec3f(up * (half_side * (0.5 * (window.top - window.bottom))));
}

}  // namespace

Camera compile_camera(const description::Camera& camera, const Normalisation& normalisation,
                      const CompileOptions& options) {
  const Vec3d to_target = camera.target - camera.eye;
  const Vec3d look = normalize(to_target);
  const Vec3d to_the_right = normalize(cross(look, camera.up));
  const Vec3d up = cross(to_the_right, look);
  const Vec3d right = camera.is_mirrored ? -to_the_right : to_the_right;
  const double aspect = static_cast<double>(options.width) / options.height;
  const double focus = camera.focus_distance > 0 ? camera.focus_distance : length(to_target);

  Camera out;
  out.kind = camera.kind;
  Vec3d eye = (camera.eye - normalisation.centre) * normalisation.scale;
  Vec3d middle = look;
  out.right = Vec3f(right);
  out.up = Vec3f(up);
  if (camera.kind == description::CameraKind::Perspective)
    set_window(camera, right, up, std::tan(camera.fovy_degrees * (pi_double / 180) / 2), aspect,
               out, middle);
  if (camera.kind == description::CameraKind::Orthographic)
    set_window(camera, right, up, normalisation.scale, aspect, out, eye);
  out.eye = Vec3f(eye);
  out.look = Vec3f(middle);
  out.lens_radius = static_cast<float>(camera.lens_radius * normalisation.scale);
  out.focus_distance = static_cast<float>(focus * normalisation.scale);
  return out;
}

}  // namespace candela
