#include "renderer/texture/texel_filter.h"

#include "renderer/image/lanes_half.h"
#include "renderer/math/lanes_power.h"
#include "renderer/texture/sample_value.h"

namespace candela {
namespace {

// (GCC converts vectors of four bytes one by one.)
Float4 four_bytes(const std::byte* place) {
#if defined(__SSE2__)
  const __m128i zero = _mm_setzero_si128();
  const __m128i bytes = _mm_cvtsi32_si128(value_at<std::int32_t>(place));
  return _mm_cvtepi32_ps(_mm_unpacklo_epi16(_mm_unpacklo_epi8(bytes, zero), zero));
#else
  using Byte4 = std::uint8_t __attribute__((vector_size(4)));
  return __builtin_convertvector(value_at<Byte4>(place), Float4);
#endif
}

// Four samples as stored; a texel of three brings its neighbour's first along, which is ignored.
template <SampleType type>
Float4 four_stored(const std::byte* place) {
  if constexpr (type == SampleType::U8) {
    return four_bytes(place);
  } else if constexpr (type == SampleType::Half) {
    return half_to_float(value_at<Half4>(place));
  } else if constexpr (type == SampleType::Float) {
    return value_at<Float4>(place);
  } else {
    return Float4{stored<type>(place), stored<type>(place + 2), stored<type>(place + 4),
                  stored<type>(place + 6)};
  }
}

template <SampleType type, int channels>
[[gnu::always_inline]] inline float stored_alpha(const std::byte* place) {
  return stored<type>(place + (channels - 1) * size_of(type));
}

// In stored units, or colour decoded; alpha is as stored in any case. What a file without alpha has
// in its place is ignored. (The four calls of a lookup are too many for GCC to inline by itself.)
template <SampleType type, int channels, Encoding encoding>
[[gnu::always_inline]] inline Float4 texel(const std::byte* place) {
  constexpr std::size_t step = size_of(type);
  constexpr bool has_alpha = channels % 2 == 0;
  constexpr bool is_coded = is_decoded_by_texel(encoding);
  if constexpr (channels <= 2) {
    float grey;
    if constexpr (is_coded)
      grey = decoded<type, encoding>(place);
    else
      grey = stored<type>(place);
    return Float4{grey, grey, grey, has_alpha ? stored_alpha<type, channels>(place) : 0.0f};
  } else if constexpr (is_coded) {
    return Float4{decoded<type, encoding>(place), decoded<type, encoding>(place + step),
                  decoded<type, encoding>(place + 2 * step),
                  has_alpha ? stored_alpha<type, channels>(place) : 0.0f};
  } else {
    return four_stored<type>(place);
  }
}

// Of `read(place)` at four texels; beyond a border zeros.
template <class Value, std::size_t texel_bytes, bool has_border>
[[gnu::always_inline]] inline Value bilinear(const TexelView& view, const Footprint& footprint,
                                             const auto& read) {
  const auto at = [&](std::int32_t column, std::int32_t row) -> Value {
    if constexpr (has_border)
      if (column < 0 || row < 0) return Value{};
    const std::size_t index = static_cast<std::size_t>(row) * static_cast<std::size_t>(view.width) +
                              static_cast<std::size_t>(column);
    return read(view.samples + index * texel_bytes);
  };
  const auto& [column, row] = footprint;
  const Value upper =
      between(at(column.first, row.first), at(column.second, row.first), column.weight);
  const Value lower =
      between(at(column.first, row.second), at(column.second, row.second), column.weight);
  return between(upper, lower, row.weight);
}

// What texel() has, filtered or not, decoded to linear.
template <SampleType type, int channels, Encoding encoding>
[[gnu::always_inline]] inline Vec4f linear(Float4 value) {
  constexpr bool has_alpha = channels % 2 == 0;
  const float alpha = has_alpha ? value[3] / unit<type> : 1.0f;
  if constexpr (!is_decoded_by_texel(encoding)) value = value / unit<type>;
  if constexpr (encoding == Encoding::LabGamma) value = power_2_2(value);
  return {value[0], value[1], value[2], alpha};
}

template <SampleType type, int channels, Encoding encoding, bool has_border>
Vec4f filter(const TexelView& view, const Footprint& footprint) {
  return linear<type, channels, encoding>(bilinear<Float4, size_of(type) * channels, has_border>(
      view, footprint, texel<type, channels, encoding>));
}

// The same bits as a filter of one texel; the lab's bytes, skies of many, without a power for each.
template <SampleType type, int channels, Encoding encoding>
[[gnu::always_inline]] inline Vec4f linear_texel(const std::byte* place) {
  if constexpr (type == SampleType::U8 && encoding == Encoding::LabGamma)
    return linear_texel<type, channels, Encoding::Gamma22>(place);  // by a table
  return linear<type, channels, encoding>(texel<type, channels, encoding>(place));
}

template <SampleType type, int channels, Encoding encoding>
void read_row(const TexelView& view, std::int32_t row, std::span<Vec4f> texels) {
  constexpr std::size_t texel_bytes = size_of(type) * channels;
  const std::byte* place = view.samples + static_cast<std::size_t>(row) *
                                              static_cast<std::size_t>(view.width) * texel_bytes;
  for (Vec4f& of : texels) {
    of = linear_texel<type, channels, encoding>(place);
    place += texel_bytes;
  }
}

template <SampleType type, int channels, bool has_border>
float filter_alpha(const TexelView& view, const Footprint& footprint) {
  if constexpr (channels % 2 != 0) return 1;  // beyond the file's edges, too
  return bilinear<float, size_of(type) * channels, has_border>(view, footprint,
                                                               stored_alpha<type, channels>) /
         unit<type>;
}

template <SampleType type, int channels, bool has_border>
TexelFilters chosen_encoding(Encoding encoding) {
  const TexelFilter as_stored = filter<type, channels, Encoding::Linear, has_border>;
  const TexelFilter srgb = filter<type, channels, Encoding::Srgb, has_border>;
  const TexelFilter gamma = filter<type, channels, Encoding::Gamma22, has_border>;
  const AlphaFilter alpha = filter_alpha<type, channels, has_border>;
  switch (encoding) {
    case Encoding::Linear:
      return {as_stored, as_stored, alpha, read_row<type, channels, Encoding::Linear>};
    case Encoding::Srgb:
      return {srgb, srgb, alpha, read_row<type, channels, Encoding::Srgb>};
    case Encoding::Gamma22:
      return {gamma, gamma, alpha, read_row<type, channels, Encoding::Gamma22>};
    case Encoding::LabGamma:
      return {filter<type, channels, Encoding::LabGamma, has_border>, as_stored, alpha,
              read_row<type, channels, Encoding::LabGamma>};
  }
  return {};
}

}  // namespace

TexelFilters texel_filters(SampleType type, int channels, Encoding encoding, bool has_border) {
  return with_format(type, channels, [&]<SampleType of_type, int of_channels>() {
    return has_border ? chosen_encoding<of_type, of_channels, true>(encoding)
                      : chosen_encoding<of_type, of_channels, false>(encoding);
  });
}

}  // namespace candela
