#include "renderer/sampling/spherical_rectangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "renderer/math/constants.h"
#include "renderer/math/double2.h"
#include "renderer/math/transcendental.h"

namespace candela {
namespace {

// A unit complex number: angles are added by multiplying, without any arc cosine.
struct Turn {
  double cos, sin;

  // By the double of the angle.
  [[nodiscard]] Turn twice() const { return {1 - 2 * sin * sin, 2 * sin * cos}; }
  friend Turn operator*(const Turn& a, const Turn& b) {
    return {a.cos * b.cos - a.sin * b.sin, a.sin * b.cos + a.cos * b.sin};
  }
};

// By 0 <= angle <= 2 pi, error below 1e-14: the series of an eighth of it, doubled three times.
// Without branches, which random numbers would decide.
Turn turn_by(double angle) {
  const double r = angle * 0.125;
  const double z = r * r;
  const double z2 = z * z;
  const double sine = (1 - z * (1.0 / 6)) +
                      z2 * ((1.0 / 120 - z * (1.0 / 5040)) +
                            z2 * ((1.0 / 362880 - z * (1.0 / 39916800)) + z2 * (1.0 / 6227020800)));
  const double cosine = (1 - z * (1.0 / 2)) +
                        z2 * ((1.0 / 24 - z * (1.0 / 720)) +
                              z2 * ((1.0 / 40320 - z * (1.0 / 3628800)) + z2 * (1.0 / 479001600)));
  return Turn{cosine, r * sine}.twice().twice().twice();
}

// Two at a time, since square roots and divisions are what takes time here.
Double2 square_root(Double2 x) {
#if defined(__SSE2__)
  return _mm_sqrt_pd(x);
#else
  return Double2{std::sqrt(x[0]), std::sqrt(x[1])};
#endif
}

// Of the great circles through two opposite edges at the signed distances `aside` from the origin's
// foot: the components n of their normals along the plane's, and m = sqrt(1 - n^2) without
// cancellation.
struct EdgePlanes {
  Double2 n, m;
};
EdgePlanes edge_planes(Double2 aside, double height) {
  const Double2 inverse = 1.0 / square_root(aside * aside + height * height);
  return {aside * inverse, height * inverse};
}

// The inner angles of neighbours, lane by lane: their cosines are -n n' [Urena13, eq. 5].
struct Turns {
  Double2 cos, sin;

  [[nodiscard]] Turn lane(int i) const { return {cos[i], sin[i]}; }
};
Turns angles_between(const EdgePlanes& a, const EdgePlanes& b) {
  return {-a.n * b.n, square_root(a.m * a.m + a.n * a.n * b.m * b.m)};
}

}  // namespace

SphericalRectangle make_spherical_rectangle(double x0, double y0, double x1, double y1,
                                            double height) {
  if (!(height > 0)) return {};  // seen from its own plane, or from nowhere
  const EdgePlanes y = edge_planes(Double2{-y0, y1}, height);
  const EdgePlanes x = edge_planes(Double2{x1, -x0}, height);
  const Turns beside = angles_between(y, x);  // y0 and x1, y1 and x0
  const Turns across = angles_between({Double2{y.n[1], y.n[0]}, Double2{y.m[1], y.m[0]}},
                                      x);  // y1 and x1, y0 and x0
  const Turn at_x1 = beside.lane(0) * across.lane(0);
  const Turn at_x0 = beside.lane(1) * across.lane(1);
  const Turn excess = at_x0 * at_x1;  // of the four angles over 2 pi, by Girard's theorem
  const float angle = arc_tangent(static_cast<float>(excess.sin), static_cast<float>(excess.cos));
  return {.x0 = x0,
          .y0 = y0,
          .x1 = x1,
          .y1 = y1,
          .height = height,
          .n0 = y.n[0],
          .m0 = y.m[0],
          .n2 = y.n[1],
          .cos_k = at_x0.cos,
          .sin_k = -at_x0.sin,
          .solid_angle = angle < 0 ? angle + two_pi : angle};
}

// [Urena13, section 4.2], with the sine of what is sampled from its own square: 1 - cu^2 cancels.
Vec2d SphericalRectangle::point(Vec2f u) const {
  const double angle = static_cast<double>(u.x) * static_cast<double>(solid_angle);
  const Turn au = turn_by(angle) * Turn{cos_k, sin_k};
  constexpr double tiny = std::numeric_limits<double>::min();  // in place of 0 below a fraction
  const double f = (au.cos * n0 - n2) / (au.sin != 0 ? au.sin : tiny);
  const double aside = height / std::sqrt(std::max(f * f - m0 * m0, tiny));
  const double x = std::min(std::max(x0, std::copysign(aside, f)), x1);
  const double d2 = x * x + height * height;
  const Double2 ys{y0, y1};
  const Double2 hs = ys / square_root(d2 + ys * ys);
  const double h = hs[0] + static_cast<double>(u.y) * (hs[1] - hs[0]);
  const double y = h * std::sqrt(d2 / std::max((1 - h) * (1 + h), tiny));
  return {x, std::min(std::max(y0, y), y1)};
}

Vec2f SphericalRectangle::place_of(Vec2d point) const {
  const double x = std::clamp(point.x, x0, x1);
  const double y = std::clamp(point.y, y0, y1);
  const double d2 = x * x + height * height;
  const double h0 = y0 / std::sqrt(d2 + y0 * y0);
  const double h1 = y1 / std::sqrt(d2 + y1 * y1);
  const double h = y / std::sqrt(d2 + y * y);
  const float part = make_spherical_rectangle(x0, y0, x, y1, height).solid_angle / solid_angle;
  const auto across = static_cast<float>((h - h0) / (h1 - h0));
  return {std::min(std::max(0.0f, part), 1.0f), std::min(std::max(0.0f, across), 1.0f)};
}

}  // namespace candela
