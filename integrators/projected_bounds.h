// Where on a camera's film a set of points and all between them can be seen, at most.
#pragma once

#include <span>

#include "renderer/camera/camera.h"
#include "renderer/math/bounds.h"
#include "renderer/math/vec.h"

namespace candela {

// Along the film's axes from the picture's middle, edges at -1 and 1, y upwards; may be infinite.
// Empty where nothing is before the camera.
using FilmBounds = Bounds<Vec2d>;

class Projection {
 public:
  // Perspective without a lens, or orthographic. `extent`: of the coordinates of all that is
  // projected, which tells how far they may be rounded.
  Projection(const Camera& camera, double extent);

  // As multiples of the camera's right, up and look; z: how far before the camera.
  using Point = Vec3d;
  [[nodiscard]] Point point(const Vec3f& p) const { return inverse_ * (Vec3d(p) - eye_); }

  // Of the points' convex hull.
  [[nodiscard]] FilmBounds bounds(std::span<const Point> points) const;

 private:
  [[nodiscard]] static FilmBounds everywhere();
  [[nodiscard]] FilmBounds perspective_bounds(std::span<const Point> points) const;

  bool is_perspective_;
  Vec3d eye_;
  Mat3d inverse_;
  Vec3d error_;           // of a point's place, per axis
  double ray_error_ = 0;  // of where on the film a ray passes
};

}  // namespace candela
