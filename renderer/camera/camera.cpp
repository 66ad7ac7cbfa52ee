#include "renderer/camera/camera.h"

#include "renderer/math/lat_long_map.h"
#include "renderer/sampling/equal_area.h"

namespace candela {

Ray Camera::generate_other_ray(Vec2f film, Vec2f lens) const {
  if (kind == CameraKind::Orthographic) {
    const Vec3f origin = eye + right * (2 * film.x - 1) + up * (1 - 2 * film.y);
    if (lens_radius == 0) return {origin, look, infinity};
    const Vec3f offset = lens_offset(lens);
    return {origin + offset, normalize(look * focus_distance - offset), infinity};
  }
  if (kind == CameraKind::LatLong) {
    const Vec3f d = lat_long_direction(film);  // whose middle looks along -z
    return {eye, normalize(right * d.x + up * d.y - look * d.z), infinity};
  }
  const Vec3f d = square_to_equal_area_sphere(wrap_equal_area_square(film));  // filters reach out
  return {eye, normalize(right * d.x + look * d.y + up * d.z), infinity};
}

}  // namespace candela
