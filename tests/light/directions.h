// Tools for tests of samplers of directions: random numbers, quadrature over a cap of the sphere,
// and the chi-square test of samples against a density.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "renderer/geometry/surface_point.h"
#include "renderer/math/frame.h"
#include "renderer/math/vec.h"
#include "tests/statistics/moments.h"

namespace candela::light_test {

// In [0, 1), as good as independent for different (i, stream).
[[nodiscard]] float random_unit(std::uint64_t i, std::uint64_t stream);
[[nodiscard]] Vec2f random_pair(std::uint64_t i, std::uint64_t stream);
[[nodiscard]] Vec3f random_direction(std::uint64_t i, std::uint64_t stream);

// A point without rounding errors and without a surface, to sample lights from.
[[nodiscard]] inline SurfacePoint at(const Vec3f& position) {
  SurfacePoint point;
  point.position = position;
  return point;
}

// The directions within acos(cos_min) of frame.z; the whole sphere by default.
struct Cap {
  Frame frame;
  double cos_min = -1;

  [[nodiscard]] double solid_angle() const;
  // (a, b) in [0, 1]^2, uniform in solid angle.
  [[nodiscard]] Vec3f direction(double a, double b) const;
  // The inverse; empty outside of the cap.
  [[nodiscard]] std::optional<Vec2d> coordinates(const Vec3f& direction) const;
};

using DirectionFunction = std::function<double(const Vec3f&)>;
// A direction, or none where the sampler rejects.
using DirectionSampler = std::function<std::optional<Vec3f>(Vec2f)>;

// By the midpoint rule on steps x steps pieces of equal solid angle.
[[nodiscard]] double integral(const Cap& cap, int steps, const DirectionFunction& f);

// The same by `count` random directions, with its standard error: for what has sharp edges.
[[nodiscard]] statistics::Moments random_integral(const Cap& cap, std::uint64_t count,
                                                  const DirectionFunction& f);

// The p-value of `count` samples on bins x bins pieces of the cap against the density, which is
// integrated over each piece by the midpoint rule. Pieces in which the density vanishes anywhere
// (the quadrature of an edge would be poor), what falls outside of the cap and what is rejected
// share one cell, which expects what the others lack to 1. So that this cell never expects so
// little that the quadrature's error matters, the last slice of azimuth is thrown in.
[[nodiscard]] double chi_square_p_value(const Cap& cap, int bins, std::uint64_t count,
                                        const DirectionSampler& sample,
                                        const DirectionFunction& pdf);

// Irradiance from a polygon of unit radiance by Lambert's formula: half the sum over edges of the
// angle they subtend times the cosine of their plane's normal; all of the polygon lies above.
[[nodiscard]] double lambert_irradiance(const std::vector<Vec3d>& polygon, const Vec3d& p,
                                        const Vec3d& n);

}  // namespace candela::light_test
