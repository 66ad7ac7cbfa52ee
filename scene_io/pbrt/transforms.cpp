#include "scene_io/pbrt/transforms.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/floating_point_traps.h"
#include "renderer/math/constants.h"

namespace candela::pbrt {

Transform scaling(const Vec3d& factors) {
  return {Mat3d(factors.x, 0, 0, 0, factors.y, 0, 0, 0, factors.z), Vec3d(0.0)};
}

// Rodrigues' formula: cos I + (1 - cos) a a^T + sin [a]x, column by column.
Transform rotation(double degrees, const Vec3d& axis) {
  const double angle = std::remainder(degrees, 360.0) * (pi_double / 180);
  const Vec3d a = normalize(axis / max_component(glm::abs(axis)));
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Transform out;
  for (int column = 0; column < 3; ++column) {
    Vec3d unit(0.0);
    unit[column] = 1;
    out.linear[column] = unit * c + a * (a[column] * (1 - c)) + cross(a, unit) * s;
  }
  return out;
}

Transform looking(const Vec3d& eye, const Vec3d& look_at, const Vec3d& up) {
  const FloatingPointTraps traps(Traps::Off);  // directions without a length are the caller's
  const Vec3d z = normalize(look_at - eye);
  const Vec3d x = normalize(cross(normalize(up), z));
  const Vec3d y = cross(z, x);
  return inverse(Transform{Mat3d(x, y, z), eye});
}

Transform affine(const std::array<double, 16>& m) {
  const Mat3d linear(m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]);
  return {linear / m[15], Vec3d(m[12], m[13], m[14]) / m[15]};
}

bool is_affine(const std::array<double, 16>& m) {
  // Exporters calculate in floats; the first three are multiplied by coordinates.
  return std::max({std::abs(m[3]), std::abs(m[7]), std::abs(m[11])}) < 1e-9 &&
         std::abs(m[15] - 1) < 1e-6;
}

bool has_finite_numbers(const Transform& transform) {
  const Mat3d& linear = transform.linear;
  return is_finite(linear[0]) && is_finite(linear[1]) && is_finite(linear[2]) &&
         is_finite(transform.translation);
}

}  // namespace candela::pbrt
