// Affine maps in double: p' = linear * p + translation.
#pragma once

#include "renderer/math/vec.h"

namespace candela {

struct Transform {
  Mat3d linear{1.0};
  Vec3d translation{0.0};

  [[nodiscard]] Vec3d point(const Vec3d& p) const { return linear * p + translation; }
  [[nodiscard]] Vec3d vector(const Vec3d& v) const { return linear * v; }
  // Not normalised. Adjugate-transposed in place of inverse-transposed: right up to a positive
  // factor, also for singular maps; a mirroring map keeps the normal on its side.
  [[nodiscard]] Vec3d normal(const Vec3d& n) const {
    const Mat3d cofactor(cross(linear[1], linear[2]), cross(linear[2], linear[0]),
                         cross(linear[0], linear[1]));
    return (determinant() < 0 ? -1.0 : 1.0) * (cofactor * n);
  }
  [[nodiscard]] double determinant() const { return dot(linear[0], cross(linear[1], linear[2])); }
  [[nodiscard]] bool is_identity() const {
    return linear == Mat3d(1.0) && translation == Vec3d(0.0);
  }
};

// Whether a map flattens space, up to rounding: the volume of the image of a cube against that of a
// box with its edges.
[[nodiscard]] inline bool is_singular(const Mat3d& linear) {
  double largest = 0;
  for (int c = 0; c < 3; ++c) largest = std::max(largest, max_component(glm::abs(linear[c])));
  if (!(largest > 0)) return true;
  const Transform scaled{linear / largest, {}};
  double edges = 1;
  for (int c = 0; c < 3; ++c) edges *= length(scaled.linear[c]);
  return !(std::abs(scaled.determinant()) > 1e-12 * edges);
}

// The factor by which a map that keeps all shapes (a similarity, mirrored or not) enlarges them; 0
// for any other map. `tolerance`: of cosines and of relative lengths, as files write their numbers.
[[nodiscard]] inline double similarity_scale(const Transform& t, double tolerance = 1e-5) {
  const Mat3d& m = t.linear;
  const double mean = (length_squared(m[0]) + length_squared(m[1]) + length_squared(m[2])) / 3;
  if (!(mean > 0) || !std::isfinite(mean)) return 0;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      if (!(std::abs(dot(m[i], m[j]) / mean - (i == j ? 1 : 0)) <= 2 * tolerance)) return 0;
  return std::sqrt(mean);
}

[[nodiscard]] inline Transform operator*(const Transform& a, const Transform& b) {
  return {a.linear * b.linear, a.linear * b.translation + a.translation};
}

[[nodiscard]] inline Transform inverse(const Transform& t) {
  const Mat3d linear = glm::inverse(t.linear);
  return {linear, -(linear * t.translation)};
}

}  // namespace candela
