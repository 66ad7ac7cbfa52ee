#include "renderer/texture/texel_filter.h"

#include <array>
#include <cstring>

#include "renderer/image/half.h"
#include "renderer/math/colour.h"
#include "renderer/math/transcendental.h"

namespace candela {
namespace {

std::array<float, 256> byte_table(bool is_srgb) {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double value = static_cast<double>(i) / 255;
    table[i] = static_cast<float>(is_srgb ? srgb_to_linear(value) : value);
  }
  return table;
}

const std::array<float, 256> linear_bytes = byte_table(false);
const std::array<float, 256> srgb_bytes = byte_table(true);

// IEC 61966-2-1 for samples that have no table.
float decoded_srgb(float value) {
  return value <= 0.04045f ? value * (1 / 12.92f) : power((value + 0.055f) * (1 / 1.055f), 2.4);
}

template <class Sample>
Sample sample_at(const std::byte* place) {
  Sample sample;
  std::memcpy(&sample, place, sizeof(Sample));
  return sample;
}

template <SampleType type>
float stored(const std::byte* place) {
  if constexpr (type == SampleType::U8)
    return linear_bytes[sample_at<std::uint8_t>(place)];
  else if constexpr (type == SampleType::U16)
    return static_cast<float>(sample_at<std::uint16_t>(place)) * (1 / 65535.0f);
  else if constexpr (type == SampleType::Half)
    return half_to_float(sample_at<std::uint16_t>(place));
  else
    return sample_at<float>(place);
}

template <SampleType type, bool is_srgb>
float colour(const std::byte* place) {
  if constexpr (!is_srgb)
    return stored<type>(place);
  else if constexpr (type == SampleType::U8)
    return srgb_bytes[sample_at<std::uint8_t>(place)];
  else
    return decoded_srgb(stored<type>(place));
}

template <SampleType type, int channels, bool is_srgb>
Vec4f texel(const std::byte* place) {
  constexpr std::size_t step = size_of(type);
  const float first = colour<type, is_srgb>(place);
  if constexpr (channels == 1) return {first, first, first, 1};
  if constexpr (channels == 2) return {first, first, first, stored<type>(place + step)};
  const float second = colour<type, is_srgb>(place + step);
  const float third = colour<type, is_srgb>(place + 2 * step);
  if constexpr (channels == 3)
    return {first, second, third, 1};
  else
    return {first, second, third, stored<type>(place + 3 * step)};
}

// Exact where both ends are equal.
Vec4f between(const Vec4f& a, const Vec4f& b, float weight) {
  return a + weight * (b - a);
}

template <SampleType type, int channels, Encoding encoding, bool has_border>
Vec4f filter(const TexelView& view, const Footprint& footprint) {
  constexpr std::size_t texel_bytes = size_of(type) * channels;
  const auto at = [&](std::int32_t column, std::int32_t row) -> Vec4f {
    if constexpr (has_border)
      if (column < 0 || row < 0) return {0, 0, 0, channels % 2 == 0 ? 0 : 1};
    const std::size_t index = static_cast<std::size_t>(row) * static_cast<std::size_t>(view.width) +
                              static_cast<std::size_t>(column);
    return texel<type, channels, encoding == Encoding::Srgb>(view.samples + index * texel_bytes);
  };
  const auto& [column, row] = footprint;
  const Vec4f upper =
      between(at(column.first, row.first), at(column.second, row.first), column.weight);
  const Vec4f lower =
      between(at(column.first, row.second), at(column.second, row.second), column.weight);
  const Vec4f result = between(upper, lower, row.weight);
  if constexpr (encoding != Encoding::LabGamma) return result;
  if constexpr (channels <= 2) {
    const float grey = power(result.x, 2.2);
    return {grey, grey, grey, result.w};
  }
  return {power(result.x, 2.2), power(result.y, 2.2), power(result.z, 2.2), result.w};
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
