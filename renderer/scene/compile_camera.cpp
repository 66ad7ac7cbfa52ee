#include "renderer/scene/compile_camera.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "renderer/math/near_one.h"

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

// Half of a side of the picture's view where the window has 1: of the plane one unit away, or for
// orthographic cameras of the scene.
double half_side_of(const description::Camera& camera, const Normalisation& normalisation) {
  return camera.kind == description::CameraKind::Orthographic
             ? normalisation.scale
             : std::tan(camera.fovy_degrees * (pi_double / 180) / 2);
}

void set_window(const description::Camera& camera, const Vec3d& right, const Vec3d& up,
                double half_side, double aspect, Camera& out, Vec3d& middle) {
  const ScreenWindow window = window_of(camera, aspect);
  middle += right * (half_side * (0.5 * (window.left + window.right))) +
            up * (half_side * (0.5 * (window.bottom + window.top)));
  out.right = Vec3f(right * (half_side * (0.5 * (window.right - window.left))));
  out.up = Vec3f(up * (half_side * (0.5 * (window.top - window.bottom))));
}

// Of the scene's size. Floats resolve nothing of what is further away, and their squares end.
constexpr double farthest = 1e12;
constexpr double nearest = 1e-12;

double focus_distance_of(const description::Camera& camera, double scale) {
  return camera.focus_distance > 0 ? camera.focus_distance * scale
                                   : length((camera.target - camera.eye) * scale);
}

// How far a window given by the file reaches from its middle; 0 where there is none.
double reach_of_window(const description::Camera& camera, const Normalisation& normalisation) {
  const ScreenWindow window = camera.screen_window.value_or(ScreenWindow{0, 0, 0, 0});
  const double reach = std::max({std::abs(window.left), std::abs(window.right),
                                 std::abs(window.bottom), std::abs(window.top)});
  return reach * half_side_of(camera, normalisation);
}

}  // namespace

Camera compile_camera(const description::Camera& camera, const Normalisation& normalisation,
                      const CompileOptions& options) {
  const Vec3d look = normalize(near_one(camera.target - camera.eye));
  const Vec3d to_the_right = normalize(cross(look, near_one(camera.up)));
  const Vec3d up = cross(to_the_right, look);
  const Vec3d right = camera.is_mirrored ? -to_the_right : to_the_right;
  const double aspect = static_cast<double>(options.width) / options.height;

  Camera out;
  out.kind = camera.kind;
  Vec3d eye = (camera.eye - normalisation.centre) * normalisation.scale;
  Vec3d middle = look;
  out.right = Vec3f(right);
  out.up = Vec3f(up);
  if (camera.kind == description::CameraKind::Perspective)
    set_window(camera, right, up, half_side_of(camera, normalisation), aspect, out, middle);
  if (camera.kind == description::CameraKind::Orthographic)
    set_window(camera, right, up, half_side_of(camera, normalisation), aspect, out, eye);
  out.eye = Vec3f(eye);
  out.look = Vec3f(middle);
  out.lens_radius = static_cast<float>(camera.lens_radius * normalisation.scale);
  // Without a lens it changes no ray, and beyond the farthest none is another one.
  const double focus = focus_distance_of(camera, normalisation.scale);
  out.focus_distance = static_cast<float>(std::clamp(focus, nearest, farthest));
  return out;
}

void check_distances(const description::Camera& camera, const Normalisation& normalisation,
                     Diagnostics& diagnostics) {
  const auto refuse = [&](const char* what, double sizes, const char* expected) {
    diagnostics.error(camera.span,
                      fmt::format("a camera {} {:.1e} times the scene's size, expected "
                                  "{}",
                                  what, sizes, expected));
  };
  const Vec3d eye = (camera.eye - normalisation.centre) * normalisation.scale;
  const double distance = max_component(glm::abs(eye));
  if (!(distance <= farthest)) refuse("is away from the scene by", distance, "at most 1e+12");
  const double radius = camera.lens_radius * normalisation.scale;
  if (radius > farthest) refuse("has a lens whose radius is", radius, "at most 1e+12");
  const double focus = focus_distance_of(camera, normalisation.scale);
  if (radius > 0 && focus < nearest) refuse("with a lens is focused at", focus, "at least 1e-12");
  const double reach = reach_of_window(camera, normalisation);
  if (camera.kind == description::CameraKind::Orthographic && reach > farthest)
    refuse("has a screen window that reaches to", reach, "at most 1e+12");
  if (camera.kind == description::CameraKind::Perspective && reach > farthest)
    diagnostics.error(camera.span,
                      fmt::format("a camera has a screen window that reaches to {:.1e} times its "
                                  "distance, expected at most 1e+12",
                                  reach));
}

}  // namespace candela
