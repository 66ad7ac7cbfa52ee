#include "renderer/sampling/spherical_triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/math/constants.h"
#include "renderer/math/double2.h"
#include "renderer/math/transcendental.h"

namespace candela {
namespace {

// Of angles in [-pi / 2, pi], error below 1e-13: the series of the angle or of its supplement.
Double2 sine(Double2 angle) {
  const Double2 supplement = pi_double - angle;
  const Double2 x = angle < supplement ? angle : supplement;
  const Double2 z = x * x;
  const Double2 z2 = z * z;
  const Double2 low = (1 - z * (1.0 / 6)) + z2 * (1.0 / 120 - z * (1.0 / 5040));
  const Double2 high =
      (1.0 / 362880 - z * (1.0 / 39916800)) +
      z2 * ((1.0 / 6227020800 - z * (1.0 / 1307674368000)) + z2 * (1.0 / 355687428096000));
  return x * (low + z2 * z2 * high);
}

// 1 + and 1 - the cosine between unit vectors, each without cancellation.
double one_plus_cosine(const Vec3d& a, const Vec3d& b) {
  const Vec3d sum = a + b;
  return 0.5 * dot(sum, sum);
}
double one_minus_cosine(const Vec3d& a, const Vec3d& b) {
  const Vec3d difference = a - b;
  return 0.5 * dot(difference, difference);
}

}  // namespace

// tan(solid_angle / 2) = |determinant| / (1 + the three cosines) [Oosterom83].
SphericalTriangle make_spherical_triangle(const Vec3d& apex, const Vec3d& to_b, const Vec3d& to_c) {
  SphericalTriangle t;
  const Vec3d b = apex + to_b;
  const Vec3d c = apex + to_c;
  const Vec3d lengths(length(apex), length(b), length(c));
  if (!(lengths.x > 0 && lengths.y > 0 && lengths.z > 0)) return t;  // seen from a vertex
  t.inverse_length = 1.0 / lengths;
  t.apex = apex * t.inverse_length.x;
  t.b = b * t.inverse_length.y;
  t.c = c * t.inverse_length.z;
  t.determinant = dot(t.apex, cross(to_b, to_c)) * (t.inverse_length.y * t.inverse_length.z);
  t.above_apex_b = one_plus_cosine(t.apex, t.b);
  t.above_bc = one_plus_cosine(t.b, t.c);
  t.sum = t.above_apex_b + dot(t.apex + t.b, t.c);
  constexpr double least = 1e-9;  // where the sum's rounding, some 1e-16, does not matter
  if (t.determinant != 0 && std::abs(t.determinant) + std::abs(t.sum) > least)
    t.solid_angle =
        2 * arc_tangent(static_cast<float>(std::abs(t.determinant)), static_cast<float>(t.sum));
  return t;
}

// The triangle of apex, b and a point p of the arc bc has the part u.x of the solid angle E where,
// by the formula above, p is b mirrored in alpha b + beta c [Peters21]; `rest` is alpha - beta, the
// one difference here, and 0 at c. On the arc from the apex to p the cosine is uniform [Arvo95].
Vec2d SphericalTriangle::point(Vec2f u) const {
  const double part = 0.5 * static_cast<double>(solid_angle) * static_cast<double>(u.x);
  const Double2 turn = sine(Double2{part, 0.5 * pi_double - part});
  const double beta = above_apex_b * turn[0];
  const double rest = std::max(std::abs(determinant) * turn[1] - sum * turn[0], 0.0);
  const double twice = 2 * beta * (beta + rest) * above_bc;
  const double norm = 1 / (rest * rest + twice);
  const double p_b = rest * (2 * beta + rest) * norm;
  const double p_c = 2 * beta * (rest + beta * above_bc) * norm;
  const Vec3d p = b * p_b + c * p_c;

  // The direction is share_apex apex + share_p p.
  const auto v = static_cast<double>(u.y);
  const double versine = one_minus_cosine(apex, p);
  const double coversine = std::max(one_plus_cosine(apex, p), std::numeric_limits<double>::min());
  const double share_p = std::sqrt(v * (2 * (1 - v) + v * coversine) / coversine);
  const double share_apex = (1 - share_p) + versine * (share_p - v);
  const double weight_apex = share_apex * inverse_length.x;
  const double weight_b = share_p * p_b * inverse_length.y;
  const double weight_c = share_p * p_c * inverse_length.z;
  const double whole = 1 / (weight_apex + (weight_b + weight_c));
  return {weight_b * whole, weight_c * whole};
}

Vec2f SphericalTriangle::place_of(const Vec3d& direction) const {
  // The direction is a sum of the three vertices by these weights.
  const double sign = std::copysign(1.0, determinant);
  const double weight_b = std::max(0.0, dot(direction, cross(c, apex)) * sign);
  const double weight_c = std::max(0.0, dot(direction, cross(apex, b)) * sign);
  const Vec3d towards_p = b * weight_b + c * weight_c;
  const double length2 = dot(towards_p, towards_p);
  if (!(length2 > 0)) return {0, 0};  // towards the apex
  const double inverse = 1 / std::sqrt(length2);
  const Vec3d p = towards_p * inverse;
  const double part_determinant = std::abs(determinant) * (weight_c * inverse);
  const double part_sum = above_apex_b + dot(apex + b, p);
  const float part_angle =
      2 * arc_tangent(static_cast<float>(part_determinant), static_cast<float>(part_sum));
  const double along =
      one_minus_cosine(direction, apex) / std::max(one_minus_cosine(p, apex), 1e-300);
  return {std::min(part_angle / solid_angle, 1.0f), static_cast<float>(std::min(along, 1.0))};
}

}  // namespace candela
