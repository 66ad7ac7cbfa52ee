// Where on a camera's film a set of points and all between them can be seen, at most.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "renderer/camera/camera.h"
#include "renderer/math/bounds.h"
#include "renderer/math/vec.h"

namespace candela {

// Along the film's axes from the picture's middle, edges at -1 and 1, y upwards; may be infinite.
// Empty where nothing is before the camera.
using FilmBounds = Bounds<Vec2d>;

// The largest coordinate, whatever its sign.
[[nodiscard]] inline double extent_of(const Bounds3f& bounds) {
  return static_cast<double>(
      std::max(max_component(glm::abs(bounds.lower)), max_component(glm::abs(bounds.upper))));
}

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

  // Where the points themselves are seen, and how far that may be off along each axis; none where
  // not all of them are before the camera.
  [[nodiscard]] std::optional<Vec2d> places(std::span<const Point> points,
                                            std::vector<Vec2d>& seen) const;

 private:
  // Of a place where a perspective camera sees a point.
  [[nodiscard]] Vec2d perspective_error(const Vec2d& seen, double depth) const {
    return (Vec2d(error_) + glm::abs(seen) * error_.z) / (depth - error_.z) + ray_error_;
  }
  [[nodiscard]] static FilmBounds everywhere();
  [[nodiscard]] FilmBounds perspective_bounds(std::span<const Point> points) const;

  bool is_perspective_;
  Vec3d eye_;
  Mat3d inverse_;
  Vec3d error_;           // of a point's place, per axis
  double ray_error_ = 0;  // of where on the film a ray passes
};

}  // namespace candela
