// Cameras in normalised space: perspective by pinhole or thin lens, orthographic, and all around.
#pragma once

#include "renderer/base/handle.h"
#include "renderer/description/scene_description.h"
#include "renderer/math/frame.h"
#include "renderer/math/ray.h"
#include "renderer/math/vec.h"
#include "renderer/sampling/warp.h"

namespace candela {

struct Medium;
using MediumHandle = Handle<Medium>;
using description::CameraKind;

struct Camera {
  CameraKind kind = CameraKind::Perspective;
  Vec3f eye{0};  // Orthographic: where the picture's middle is seen from
  // Perspective: from the eye to the picture's middle on the plane at distance 1; else unit, the
  // line of sight.
  Vec3f look{0, 0, -1};
  // To the middles of the picture's right and upper edges from its own middle: at distance 1, or,
  // Orthographic, lengths as they are. All around: unit.
  Vec3f right{1, 0, 0};
  Vec3f up{0, 1, 0};
  float lens_radius = 0;     // 0: pinhole
  float focus_distance = 1;  // along the line of sight
  MediumHandle medium{};     // around it

  // `film` in [0,1]^2 over the full picture, y from the top.
  [[nodiscard]] Ray generate_ray(Vec2f film, Vec2f lens) const {
    if (is_pinhole()) return pinhole_ray(film);
    if (kind != CameraKind::Perspective) return generate_other_ray(film, lens);
    Vec3f offset = lens_offset(lens);
    return {eye + offset, normalize(towards(film) * focus_distance - offset), infinity};
  }
  [[nodiscard]] bool is_pinhole() const {
    return kind == CameraKind::Perspective && lens_radius == 0;
  }
  // Of a pinhole's camera.
  [[nodiscard]] Ray pinhole_ray(Vec2f film) const {
    return {eye, normalize(towards(film)), infinity};
  }

  // How far along its line of sight, or from its eye, the camera sees a point.
  [[nodiscard]] float distance_to(const Vec3f& point) const {
    if (kind == CameraKind::Orthographic) return dot(point - eye, look);
    return length(point - eye);
  }

 private:
  // Perspective: from the eye to the plane at distance 1.
  [[nodiscard]] Vec3f towards(Vec2f film) const {
    return look + right * (2 * film.x - 1) + up * (1 - 2 * film.y);
  }
  [[nodiscard]] Vec3f lens_offset(Vec2f lens) const {
    Vec2f disk = square_to_disk(lens) * lens_radius;
    return normalize(right) * disk.x + normalize(up) * disk.y;
  }
  // Not inline: the usual camera's code stays small.
  [[nodiscard]] Ray generate_other_ray(Vec2f film, Vec2f lens) const;
};

}  // namespace candela
