// Triangles as they are seen from the origin, in long double: what spherical triangles are held
// against.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/math/vec.h"
#include "tests/light/directions.h"

namespace candela::test {

using Precise = glm::vec<3, long double, glm::defaultp>;

struct PreciseTriangle {
  Precise a, b, c;
};

// Between directions, small and straight angles included.
[[nodiscard]] inline long double angle_between(const Precise& a, const Precise& b) {
  const Precise u = a / glm::length(a);
  const Precise v = b / glm::length(b);
  return 2 * std::atan2(glm::length(u - v), glm::length(u + v));
}

struct SolidAngle {
  double steradians;
  double relative_error;  // by the rounding of long doubles
};

// By the sides alone (L'Huilier), where the code goes by a determinant.
[[nodiscard]] inline SolidAngle solid_angle(const PreciseTriangle& t) {
  const long double a = angle_between(t.b, t.c);
  const long double b = angle_between(t.c, t.a);
  const long double c = angle_between(t.a, t.b);
  const long double s = (a + b + c) / 2;
  const long double square =
      std::tan(s / 2) * std::tan((s - a) / 2) * std::tan((s - b) / 2) * std::tan((s - c) / 2);
  const long double least = std::min({s - a, s - b, s - c});
  return {static_cast<double>(4 * std::atan(std::sqrt(std::max(square, 0.0L)))),
          static_cast<double>(1e-18L / std::max(least, 1e-30L))};
}

struct TriangleCase {
  const char* name;
  Vec3d apex, to_b, to_c;

  [[nodiscard]] PreciseTriangle precise() const {
    const Precise a(apex);
    return {a, a + Precise(to_b), a + Precise(to_c)};
  }
};

// From 1e-12 sr to 2 pi: sizes of six decades, edges of up to a thousand times each other's length,
// heights of nine decades.
[[nodiscard]] inline TriangleCase random_triangle(std::uint64_t i) {
  const auto decades = [&](std::uint64_t stream, double low, double high) {
    const auto u = static_cast<double>(light_test::random_unit(i, stream));
    return std::pow(10.0, low + u * (high - low));
  };
  const double size = decades(1, -6, 0.5);
  const auto length = [&](std::uint64_t stream) {
    const double sign = light_test::random_unit(i, stream) < 0.5f ? -1 : 1;
    return sign * decades(stream + 1, -3, 0) * size;
  };
  const double height = decades(2, -9, 0);
  return {"random",
          {length(3), length(5), height},
          {length(7), length(9), 0},
          {length(11), length(13), 0}};
}

}  // namespace candela::test
