// The transforms that directives multiply onto the current one.
#pragma once

#include <array>

#include "renderer/math/transform.h"

namespace candela::pbrt {

// What cameras and the pictures of lights are stretched or sheared by less is how files write their
// numbers.
inline constexpr double seen_stretch = 1e-3;

[[nodiscard]] Transform scaling(const Vec3d& factors);
// Degrees, by the right hand about an axis of any length but 0.
[[nodiscard]] Transform rotation(double degrees, const Vec3d& axis);
// World -> camera: +z looks from the eye to `look_at`, +y is up, +x right (left-handed).
[[nodiscard]] Transform looking(const Vec3d& eye, const Vec3d& look_at, const Vec3d& up);
// Of 16 numbers, column by column as pbrt writes them. They must be affine: see is_affine().
[[nodiscard]] Transform affine(const std::array<double, 16>& numbers);
[[nodiscard]] bool is_affine(const std::array<double, 16>& numbers);
[[nodiscard]] bool has_finite_numbers(const Transform& transform);

}  // namespace candela::pbrt
