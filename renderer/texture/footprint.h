// Where a bilinear lookup reads: two columns, two rows and the weights between them.
//
// Texel centres lie at (i + 0.5) / size. Any float is a valid coordinate. Of repeats what is not
// finite counts as 0, and from 2^23 on every float is a whole number of them; clamped, NaN counts
// as 0; of Wrap::Black it lies outside.
#pragma once

#include <cmath>
#include <cstdint>

#include "renderer/description/scene_description.h"
#include "renderer/math/vec.h"

namespace candela {

using description::Wrap;

// Two neighbouring texels along one axis, and how far the place lies from the first to the second.
// -1: outside (Wrap::Black alone).
struct AxisFootprint {
  std::int32_t first = 0;
  std::int32_t second = 0;
  float weight = 0;  // of the second, in [0, 1]
};

// x - floor(x) in [0, 1]; 1 only by rounding, of tiny negative x. No call to std::floor, which
// plain x86-64 does not do in one instruction.
[[nodiscard]] inline float fraction(float x) {
  constexpr float all_whole = 8388608.0f;  // 2^23
  if (!(std::abs(x) < all_whole)) return 0;
  const float part = x - static_cast<float>(static_cast<std::int32_t>(x));
  return part < 0 ? part + 1 : part;
}

[[nodiscard]] inline float clamped_to_unit(float x) {
  return x > 0 ? (x < 1 ? x : 1.0f) : 0.0f;
}

// `place` in [0, 1] on an axis of `size` texels, not wrapped: `first` may be -1, `second` `size`.
[[nodiscard]] inline AxisFootprint plain_footprint(float place, std::int32_t size) {
  const float x = place * static_cast<float>(size) - 0.5f;
  const std::int32_t first = x < 0 ? -1 : static_cast<std::int32_t>(x);
  return {first, first + 1, x - static_cast<float>(first)};
}

[[nodiscard]] inline AxisFootprint repeated_footprint(float place, std::int32_t size) {
  AxisFootprint found = plain_footprint(place, size);
  if (found.first < 0) found.first = size - 1;
  if (found.second == size) found.second = 0;
  return found;
}

[[nodiscard]] inline AxisFootprint clamped_footprint(float place, std::int32_t size) {
  AxisFootprint found = plain_footprint(place, size);
  if (found.first < 0) found.first = 0;
  if (found.second == size) found.second = size - 1;
  return found;
}

[[nodiscard]] inline AxisFootprint bordered_footprint(float place, std::int32_t size) {
  const float half_texel = 0.5f / static_cast<float>(size);
  if (!(place > -half_texel && place < 1 + half_texel)) return {-1, -1, 0};
  AxisFootprint found = plain_footprint(place, size);
  if (found.second >= size) found.second = -1;
  if (found.first >= size) found.first = -1;
  return found;
}

// Folded to [0, 1]: there and back.
[[nodiscard]] inline float mirrored(float coordinate) {
  const float place = 2 * fraction(0.5f * coordinate);
  return place > 1 ? 2 - place : place;
}

// `is_flipped`: the coordinate runs against the texels, as v does.
[[nodiscard]] inline AxisFootprint axis_footprint(float coordinate, std::int32_t size, Wrap wrap,
                                                  bool is_flipped) {
  const auto turned = [is_flipped](float place) { return is_flipped ? 1 - place : place; };
  switch (wrap) {
    case Wrap::Repeat:
      return repeated_footprint(turned(fraction(coordinate)), size);
    case Wrap::Clamp:
      return clamped_footprint(turned(clamped_to_unit(coordinate)), size);
    case Wrap::Mirror:
      return clamped_footprint(turned(mirrored(coordinate)), size);
    case Wrap::Black:
      return bordered_footprint(turned(coordinate), size);
  }
  return {};
}

struct Footprint {
  AxisFootprint column;
  AxisFootprint row;
};

// Nearly all textures repeat, and skies end at their edges: those cases are compiled into their
// place.
[[nodiscard, gnu::always_inline]] inline Footprint footprint_of(Vec2f uv, std::int32_t width,
                                                                std::int32_t height, Wrap wrap) {
  if (wrap == Wrap::Repeat)
    return {repeated_footprint(fraction(uv.x), width),
            repeated_footprint(1 - fraction(uv.y), height)};
  if (wrap == Wrap::Clamp)
    return {clamped_footprint(clamped_to_unit(uv.x), width),
            clamped_footprint(1 - clamped_to_unit(uv.y), height)};
  return {axis_footprint(uv.x, width, wrap, false), axis_footprint(uv.y, height, wrap, true)};
}

}  // namespace candela
