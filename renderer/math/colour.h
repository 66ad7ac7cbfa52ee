// Linear Rec.709 colour and the encodings that files use.
#pragma once

#include "renderer/math/vec.h"

namespace candela {

// Relative luminance (Rec.709 weights).
[[nodiscard]] inline float luminance(const Rgb& c) {
  return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
}
[[nodiscard]] inline double luminance(const Vec3d& c) {
  return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
}
[[nodiscard]] inline float average(const Rgb& c) {
  return (c.x + c.y + c.z) * (1.0f / 3.0f);
}

// IEC 61966-2-1, encoded -> linear. For tables and compile time, not for kernels (std::pow).
[[nodiscard]] inline double srgb_to_linear(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}
// Linear -> encoded.
[[nodiscard]] inline double linear_to_srgb(double v) {
  return v <= 0.0031308 ? v * 12.92 : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

}  // namespace candela
