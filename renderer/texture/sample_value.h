// One sample of a texel, read from where it is stored; and what is chosen by how it is stored.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "renderer/description/texture_description.h"
#include "renderer/image/decode.h"
#include "renderer/image/half.h"
#include "renderer/image/value_at.h"
#include "renderer/math/transcendental.h"

namespace candela {

// sRGB's bytes, linear.
extern const std::array<float, 256> srgb_bytes;
// Those of the power 2.2, linear.
extern const std::array<float, 256> gamma_bytes;

// IEC 61966-2-1 for samples that have no table.
[[nodiscard]] inline float decoded_srgb(float value) {
  return value <= 0.04045f ? value * (1 / 12.92f) : power((value + 0.055f) * (1 / 1.055f), 2.4);
}

// What 1 is stored as.
template <SampleType type>
constexpr float unit = type == SampleType::U8    ? 255.0f
                       : type == SampleType::U16 ? 65535.0f
                                                 : 1.0f;

// As a number of [0, unit] where it is an integer.
template <SampleType type>
[[nodiscard]] float stored(const std::byte* place) {
  if constexpr (type == SampleType::U8)
    return static_cast<float>(value_at<std::uint8_t>(place));
  else if constexpr (type == SampleType::U16)
    return static_cast<float>(value_at<std::uint16_t>(place));
  else if constexpr (type == SampleType::Half)
    return half_to_float(value_at<std::uint16_t>(place));
  else
    return value_at<float>(place);
}

// Of encodings that are decoded before filtering.
[[nodiscard]] constexpr bool is_decoded_by_texel(description::Encoding encoding) {
  return encoding == description::Encoding::Srgb || encoding == description::Encoding::Gamma22;
}

// By one of these, linear.
template <SampleType type, description::Encoding encoding>
[[nodiscard]] float decoded(const std::byte* place) {
  constexpr bool is_srgb = encoding == description::Encoding::Srgb;
  if constexpr (type == SampleType::U8) {
    return (is_srgb ? srgb_bytes : gamma_bytes)[value_at<std::uint8_t>(place)];
  } else {
    const float value = stored<type>(place) / unit<type>;
    return is_srgb ? decoded_srgb(value) : power(std::max(value, 0.0f), 2.2);
  }
}

// f.operator()<type, channels>(); `channels`: 1..4.
template <SampleType type, class F>
[[nodiscard]] auto with_channels(int channels, const F& f) {
  switch (channels) {
    case 1:
      return f.template operator()<type, 1>();
    case 2:
      return f.template operator()<type, 2>();
    case 3:
      return f.template operator()<type, 3>();
    default:
      return f.template operator()<type, 4>();
  }
}
template <class F>
[[nodiscard]] auto with_format(SampleType type, int channels, const F& f) {
  switch (type) {
    case SampleType::U8:
      return with_channels<SampleType::U8>(channels, f);
    case SampleType::U16:
      return with_channels<SampleType::U16>(channels, f);
    case SampleType::Half:
      return with_channels<SampleType::Half>(channels, f);
    case SampleType::Float:
      break;
  }
  return with_channels<SampleType::Float>(channels, f);
}

// Exact where both ends are equal.
template <class Value>
[[nodiscard]] Value between(Value a, Value b, float weight) {
  return a + weight * (b - a);
}

}  // namespace candela
