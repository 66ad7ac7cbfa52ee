#include "renderer/texture/texel_filter.h"

#include <array>
#include <cstring>

#include "renderer/image/half.h"
#include "renderer/math/colour.h"
#include "renderer/math/lanes_power.h"
#include "renderer/math/transcendental.h"

namespace candela {
namespace {

std::array<float, 256> decoded_bytes() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = static_cast<float>(srgb_to_linear(static_cast<double>(i) / 255));
  return table;
}

const std::array<float, 256> srgb_bytes = decoded_bytes();

// IEC 61966-2-1 for samples that have no table.
float decoded_srgb(float value) {
  return value <= 0.04045f ? value * (1 / 12.92f) : power((value + 0.055f) * (1 / 1.055f), 2.4);
}

template <class Value>
Value value_at(const std::byte* place) {
  Value value;
  std::memcpy(&value, place, sizeof(Value));
  return value;
}

// What 1 is stored as.
template <SampleType type>
constexpr float unit = type == SampleType::U8    ? 255.0f
                       : type == SampleType::U16 ? 65535.0f
                                                 : 1.0f;

template <SampleType type>
float stored(const std::byte* place) {
  if constexpr (type == SampleType::U8)
    return static_cast<float>(value_at<std::uint8_t>(place));
  else if constexpr (type == SampleType::U16)
    return static_cast<float>(value_at<std::uint16_t>(place));
  else if constexpr (type == SampleType::Half)
    return half_to_float(value_at<std::uint16_t>(place));
  else
    return value_at<float>(place);
}

template <SampleType type>
float decoded(const std::byte* place) {
  if constexpr (type == SampleType::U8)
    return srgb_bytes[value_at<std::uint8_t>(place)];
  else
    return decoded_srgb(stored<type>(place) / unit<type>);
}

// Four samples as stored; a texel of three brings its neighbour's first along, which is ignored.
template <SampleType type>
Float4 four_stored(const std::byte* place) {
  if constexpr (type == SampleType::U8) {
    using Byte4 = std::uint8_t __attribute__((vector_size(4)));
    return __builtin_convertvector(value_at<Byte4>(place), Float4);
  } else if constexpr (type == SampleType::Float) {
    return value_at<Float4>(place);
  } else {
    return Float4{stored<type>(place), stored<type>(place + 2), stored<type>(place + 4),
                  stored<type>(place + 6)};
  }
}

// In stored units, or decoded with alpha beside it.
template <SampleType type, int channels, bool is_srgb>
Float4 texel(const std::byte* place) {
  constexpr std::size_t step = size_of(type);
  constexpr float one = is_srgb ? 1.0f : unit<type>;
  const auto alpha = [place] {
    const float value = stored<type>(place + (channels - 1) * step);
    return is_srgb ? value / unit<type> : value;
  };
  if constexpr (channels <= 2) {
    const float grey = is_srgb ? decoded<type>(place) : stored<type>(place);
    return Float4{grey, grey, grey, channels == 2 ? alpha() : one};
  } else if constexpr (is_srgb) {
    return Float4{decoded<type>(place), decoded<type>(place + step),
                  decoded<type>(place + 2 * step), channels == 4 ? alpha() : one};
  } else {
    return four_stored<type>(place);
  }
}

// Black; a file without alpha is opaque beyond its edges too.
template <SampleType type, int channels, bool is_srgb>
Float4 border_texel() {
  const float one = is_srgb ? 1.0f : unit<type>;
  return Float4{0.0f, 0.0f, 0.0f, channels % 2 == 0 ? 0.0f : one};
}

// Exact where both ends are equal.
Float4 between(Float4 a, Float4 b, float weight) {
  return a + weight * (b - a);
}

template <SampleType type, int channels, Encoding encoding, bool has_border>
Vec4f filter(const TexelView& view, const Footprint& footprint) {
  constexpr bool is_srgb = encoding == Encoding::Srgb;
  constexpr bool has_alpha = channels % 2 == 0;
  constexpr std::size_t texel_bytes = size_of(type) * channels;
  const auto at = [&](std::int32_t column, std::int32_t row) -> Float4 {
    if constexpr (has_border)
      if (column < 0 || row < 0) return border_texel<type, channels, is_srgb>();
    const std::size_t index = static_cast<std::size_t>(row) * static_cast<std::size_t>(view.width) +
                              static_cast<std::size_t>(column);
    return texel<type, channels, is_srgb>(view.samples + index * texel_bytes);
  };
  const auto& [column, row] = footprint;
  const Float4 upper =
      between(at(column.first, row.first), at(column.second, row.first), column.weight);
  const Float4 lower =
      between(at(column.first, row.second), at(column.second, row.second), column.weight);
  Float4 result = between(upper, lower, row.weight);
  if constexpr (!is_srgb) result = result / unit<type>;
  const float alpha = has_alpha ? result[3] : 1.0f;
  if constexpr (encoding == Encoding::LabGamma) result = power_2_2(result);
  return {result[0], result[1], result[2], alpha};
}

template <SampleType type, int channels, Encoding encoding>
TexelFilter chosen_border(bool has_border) {
  return has_border ? filter<type, channels, encoding, true>
                    : filter<type, channels, encoding, false>;
}

template <SampleType type, int channels>
TexelFilter chosen_encoding(Encoding encoding, bool has_border) {
  switch (encoding) {
    case Encoding::Linear:
      return chosen_border<type, channels, Encoding::Linear>(has_border);
    case Encoding::Srgb:
      return chosen_border<type, channels, Encoding::Srgb>(has_border);
    case Encoding::LabGamma:
      return chosen_border<type, channels, Encoding::LabGamma>(has_border);
  }
  return nullptr;
}

template <SampleType type>
TexelFilter chosen_channels(int channels, Encoding encoding, bool has_border) {
  switch (channels) {
    case 1:
      return chosen_encoding<type, 1>(encoding, has_border);
    case 2:
      return chosen_encoding<type, 2>(encoding, has_border);
    case 3:
      return chosen_encoding<type, 3>(encoding, has_border);
    default:
      return chosen_encoding<type, 4>(encoding, has_border);
  }
}

}  // namespace

TexelFilter texel_filter(SampleType type, int channels, Encoding encoding, bool has_border) {
  switch (type) {
    case SampleType::U8:
      return chosen_channels<SampleType::U8>(channels, encoding, has_border);
    case SampleType::U16:
      return chosen_channels<SampleType::U16>(channels, encoding, has_border);
    case SampleType::Half:
      return chosen_channels<SampleType::Half>(channels, encoding, has_border);
    case SampleType::Float:
      return chosen_channels<SampleType::Float>(channels, encoding, has_border);
  }
  return nullptr;
}

}  // namespace candela
