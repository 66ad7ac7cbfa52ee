#include "renderer/scene/compile_camera.h"

namespace candela {

Camera compile_camera(const description::Camera& camera, const Normalisation& normalisation,
                      const CompileOptions& options) {
  const Vec3d to_target = camera.target - camera.eye;
  const Vec3d look = normalize(to_target);
  const Vec3d right = normalize(cross(look, camera.up));
  const Vec3d up = cross(right, look);
  const double half_height = std::tan(camera.fovy_degrees * (pi_double / 180) / 2);
  const double aspect = static_cast<double>(options.width) / options.height;
  const double focus = camera.focus_distance > 0 ? camera.focus_distance : length(to_target);

  Camera out;
  out.eye = Vec3f((camera.eye - normalisation.centre) * normalisation.scale);
  out.look = Vec3f(look);
  out.right = Vec3f(right * (half_height * aspect));
  out.up = Vec3f(up * half_height);
  out.lens_radius = static_cast<float>(camera.lens_radius * normalisation.scale);
  out.focus_distance = static_cast<float>(focus * normalisation.scale);
  return out;
}

}  // namespace candela
