// Pixel filters by importance sampling: one sample touches one pixel, its place within the filter's
// support is drawn from the filter itself, so every sample weighs 1 [Ernst06].
#pragma once

#include <array>
#include <cstdint>

#include "renderer/math/vec.h"

namespace candela {

enum class FilterKind : std::uint8_t { Box, Gaussian, BlackmanHarris, Triangle };

// Non-negative, separable, symmetric filters of finite radius (pixels), sampled by a tabulated
// inverse of each axis' cumulative distribution.
class Filter {
 public:
  Filter(FilterKind kind, float radius);

  // A place relative to the pixel's centre, distributed as the filter.
  [[nodiscard]] Vec2f sample(Vec2f u) const { return {sample_axis(u.x), sample_axis(u.y)}; }
  [[nodiscard]] FilterKind kind() const { return kind_; }
  [[nodiscard]] float radius() const { return radius_; }

 private:
  static constexpr int intervals = 1024;
  [[nodiscard]] float sample_axis(float u) const {
    const float x = u * static_cast<float>(intervals);
    const int i = std::min(static_cast<int>(x), intervals - 1);
    const float f = x - static_cast<float>(i);
    const auto k = static_cast<std::size_t>(i);
    return inverse_[k] + (inverse_[k + 1] - inverse_[k]) * f;
  }

  FilterKind kind_;
  float radius_;
  std::array<float, intervals + 1> inverse_{};
};

// Box 0.5, Gaussian 1.5 (sigma 0.5), Blackman-Harris 1.5, triangle 1 pixels.
[[nodiscard]] float default_radius(FilterKind kind);

}  // namespace candela
