// Triangles as a unit sphere about the origin sees them: their solid angle, and points on them that
// are uniform in it [Arvo95]. From 1e-12 sr to 2 pi, needles included: points are weights of the
// vertices, made of a determinant and of sums of unit vectors, where Arvo's own form takes arc
// cosines. In double.
#pragma once

#include "renderer/math/vec.h"

namespace candela {

struct SphericalTriangle {
  Vec3d apex, b, c;         // unit, towards the vertices
  Vec3d inverse_length;     // of apex, b, c
  double determinant = 0;   // of the three, with its sign
  double above_apex_b = 0;  // 1 + the cosine of that side
  double above_bc = 0;
  double sum = 0;         // 1 + the three cosines
  float solid_angle = 0;  // sr, in [0, 2 pi]; 0: none, or not known to 1e-6 of itself

  // The weights of b and c, which with the apex's sum to 1, for u in [0, 1]^2: u.x from the edge
  // towards b to that towards c, u.y from the apex to the edge between b and c.
  [[nodiscard]] Vec2d point(Vec2f u) const;
  // The inverse of point(), of what the unit `direction` meets.
  [[nodiscard]] Vec2f place_of(const Vec3d& direction) const;
};

// The edges from the apex are asked for, since differences of the others would lose digits.
[[nodiscard]] SphericalTriangle make_spherical_triangle(const Vec3d& apex, const Vec3d& to_b,
                                                        const Vec3d& to_c);

}  // namespace candela
