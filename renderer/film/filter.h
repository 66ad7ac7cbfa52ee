// Pixel filters by importance sampling: one sample touches one pixel, its place within the filter's
// support is drawn from the filter's size, so every sample weighs the same but for the filter's
// sign [Ernst06]. Weights are 1 in the mean, so that sums over samples need no sum of weights.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "renderer/math/bounds.h"
#include "renderer/math/vec.h"

namespace candela {

enum class FilterKind : std::uint8_t {
  Box,
  Gaussian,
  BlackmanHarris,
  Triangle,
  Mitchell,  // negative from about half of its radius on
  Sinc,      // Lanczos' window about it; negative in every other lobe
};

// A rectangle of the numbers that Filter::sample() takes.
struct FilterPart {
  Vec2f first{0};
  Vec2f size{1};

  [[nodiscard]] Vec2f number(Vec2f u) const { return first + u * size; }
  // Of all samples.
  [[nodiscard]] float share() const { return size.x * size.y; }
  [[nodiscard]] bool is_whole() const { return size == Vec2f(1); }
};

// Separable, symmetric filters of finite radius (pixels), sampled by a tabulated inverse of each
// axis' cumulative distribution, of which the outermost part has a finer table: there a filter may
// be wide and next to nothing.
class Filter {
 public:
  Filter(FilterKind kind, float radius);

  // A place relative to the pixel's centre, distributed as the filter's size.
  [[nodiscard]] Vec2f sample(Vec2f u) const { return {sample_axis(u.x), sample_axis(u.y)}; }
  // All numbers whose places lie in a rectangle, and few others. The share is 0 where none do.
  [[nodiscard]] FilterPart part_within(const Bounds<Vec2d>& places) const;
  // Whether it has negative parts; else all weights are 1.
  [[nodiscard]] bool is_signed() const { return !sign_changes_.empty(); }
  // Of a sample at a place: the filter's sign, times what makes the mean of all weights 1.
  [[nodiscard]] float weight(Vec2f place) const {
    return is_signed() ? weight_on_axis(place.x) * weight_on_axis(place.y) : 1.0f;
  }
  [[nodiscard]] float radius() const { return radius_; }

 private:
  // The first of `intervals` equal parts of [0, 1] is cut into `tail_parts`, the others of the
  // lower half are whole.
  static constexpr int intervals = 1024;
  static constexpr int tail_parts = 1024;
  static constexpr int parts = tail_parts + intervals / 2 - 1;
  // The number of which inverse_[k] is the place.
  [[nodiscard]] static constexpr double number_at(int k) {
    return k < tail_parts ? k / (double{intervals} * tail_parts)
                          : (k - tail_parts + 1) / double{intervals};
  }
  [[nodiscard]] float sample_axis(float u) const {
    const float low = std::min(u, 1 - u);
    const bool is_tail = low * intervals < 1;
    const float x = low * (is_tail ? float{intervals} * tail_parts : float{intervals});
    const int first = is_tail ? 0 : tail_parts - 1;
    const int part = std::min(static_cast<int>(x) + first, parts - 1);
    const float f = x - static_cast<float>(part - first);
    const auto k = static_cast<std::size_t>(part);
    const float place = inverse_[k] + (inverse_[k + 1] - inverse_[k]) * f;
    return u < 0.5f ? place : -place;
  }

  [[nodiscard]] float weight_on_axis(float x) const {
    const auto below = std::lower_bound(sign_changes_.begin(), sign_changes_.end(), std::abs(x));
    return (below - sign_changes_.begin()) % 2 == 0 ? size_over_sum_ : -size_over_sum_;
  }
  void set_signs();
  [[nodiscard]] double share_below(double x) const;

  FilterKind kind_;
  float radius_;
  std::array<float, parts + 1> inverse_{};  // places of the lower half, up to 0
  std::vector<float> sign_changes_;         // at x > 0, in order
  float size_over_sum_ = 1;                 // the integral of |f| over that of f
};

// Box 0.5, Gaussian 1.5 (sigma 0.5), Blackman-Harris 1.5, triangle 1, Mitchell 2, sinc 4 pixels.
[[nodiscard]] float default_radius(FilterKind kind);

}  // namespace candela
