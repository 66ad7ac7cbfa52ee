// The perspective camera: pinhole or thin lens, in normalised space.
#pragma once

#include "renderer/math/frame.h"
#include "renderer/math/ray.h"
#include "renderer/math/vec.h"
#include "renderer/sampling/warp.h"

namespace candela {

struct Camera {
  Vec3f eye{0};
  Vec3f look{0, 0, -1};      // unit
  Vec3f right{1, 0, 0};      // unit times tan(fovy / 2) * width / height
  Vec3f up{0, 1, 0};         // unit times tan(fovy / 2)
  float lens_radius = 0;     // 0: pinhole
  float focus_distance = 1;  // along `look`

  // `film` in [0,1]^2 over the full picture, y from the top.
  [[nodiscard]] Ray generate_ray(Vec2f film, Vec2f lens) const {
    Vec3f through = look + right * (2 * film.x - 1) + up * (1 - 2 * film.y);
    if (lens_radius == 0) return {eye, normalize(through), infinity};
    Vec2f disk = square_to_disk(lens) * lens_radius;
    Vec3f offset = normalize(right) * disk.x + normalize(up) * disk.y;
    return {eye + offset, normalize(through * focus_distance - offset), infinity};
  }
};

}  // namespace candela
