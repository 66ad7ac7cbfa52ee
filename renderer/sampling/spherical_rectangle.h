// Rectangles as a unit sphere about the origin sees them: their solid angle, and points on them
// that are uniform in it [Urena13]. In double: beside the rectangle's plane differences of nearly
// equal numbers decide.
#pragma once

#include "renderer/math/vec.h"

namespace candela {

struct SphericalRectangle {
  // In the rectangle's axes: from (x0, y0) to (x1, y1) in a plane `height` >= 0 away.
  double x0, y0, x1, y1, height;
  // n and its complement to 1 of the great circles through the edges y0 and y1: components of their
  // unit normals along the plane's. (Those of the edges at x1 and x0 only make the angles.)
  double n0, m0, n2;
  double cos_k, sin_k;  // k: the angle that the paper's eq. 15 begins with
  float solid_angle;    // sr, in [0, 2 pi); relative error below 1e-6 from 1e-8 on

  // In the rectangle's axes, for u in [0, 1]^2.
  [[nodiscard]] Vec2d point(Vec2f u) const;
  // The inverse of point().
  [[nodiscard]] Vec2f place_of(Vec2d point) const;
};

[[nodiscard]] SphericalRectangle make_spherical_rectangle(double x0, double y0, double x1,
                                                          double y1, double height);

}  // namespace candela
