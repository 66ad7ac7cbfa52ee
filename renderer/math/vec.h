// Small vectors: the only door to GLM.
#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace candela {

using Vec2f = glm::vec2;
using Vec3f = glm::vec3;
using Vec4f = glm::vec4;
using Vec2d = glm::dvec2;
using Vec3d = glm::dvec3;
using Vec4d = glm::dvec4;
using Vec2i = glm::ivec2;
using Mat3d = glm::dmat3;  // column-major, as GLM has it

// Linear Rec.709 radiometric quantities (radiance, throughput, reflectance), one number a channel.
using Rgb = glm::vec3;

using glm::cross;
using glm::dot;
using glm::length;
using glm::normalize;

[[nodiscard]] inline float length_squared(const Vec3f& v) {
  return dot(v, v);
}
[[nodiscard]] inline double length_squared(const Vec3d& v) {
  return dot(v, v);
}

[[nodiscard]] inline float max_component(const Vec3f& v) {
  return std::max({v.x, v.y, v.z});
}
[[nodiscard]] inline double max_component(const Vec3d& v) {
  return std::max({v.x, v.y, v.z});
}
[[nodiscard]] inline float min_component(const Vec3f& v) {
  return std::min({v.x, v.y, v.z});
}

// The first where several are.
[[nodiscard]] inline int max_axis(const Vec3f& v) {
  return v.x >= v.y ? (v.x >= v.z ? 0 : 2) : (v.y >= v.z ? 1 : 2);
}
[[nodiscard]] inline int max_axis(const Vec3d& v) {
  return v.x >= v.y ? (v.x >= v.z ? 0 : 2) : (v.y >= v.z ? 1 : 2);
}

[[nodiscard]] inline double sum_of_components(const Vec3d& v) {
  return v.x + v.y + v.z;
}
// A length by another norm: never less than the usual one, at most 1.74 times it, and no squares.
[[nodiscard]] inline float sum_of_absolutes(const Vec3f& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}
[[nodiscard]] inline double sum_of_absolutes(const Vec3d& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

[[nodiscard]] inline bool is_finite(const Vec3f& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
[[nodiscard]] inline bool is_finite(const Vec3d& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
[[nodiscard]] inline bool is_black(const Rgb& c) {
  return c.x == 0 && c.y == 0 && c.z == 0;
}

[[nodiscard]] inline float square(float x) {
  return x * x;
}
[[nodiscard]] inline double square(double x) {
  return x * x;
}

// a*b - c*d with an error of 1.5 ulp, where the plain form cancels (Kahan). The products of floats
// are exact in double, so this needs no fma and gives the same bits on every processor.
[[nodiscard]] inline float difference_of_products(float a, float b, float c, float d) {
  return static_cast<float>(static_cast<double>(a) * b - static_cast<double>(c) * d);
}

}  // namespace candela
