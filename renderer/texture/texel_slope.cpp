#include "renderer/texture/texel_slope.h"

#include "renderer/texture/sample_value.h"

namespace candela {
namespace {

// Three neighbours along one axis. The place is between two of them, and the places half a texel
// before and behind it are between the first two and the last two.
struct SlopeFootprint {
  std::size_t texels[3];
  bool is_late;        // between the first two
  float weight;        // of the second of those that the place is between
  float slope_weight;  // of the last two's difference
};

template <Wrap wrap>
[[gnu::always_inline]] inline std::size_t wrapped(std::int32_t texel, std::int32_t size) {
  const bool goes_round = wrap == Wrap::Repeat && size > 1;
  if (texel < 0) texel = goes_round ? texel + size : 0;
  if (texel >= size) texel = goes_round ? texel - size : size - 1;
  return static_cast<std::size_t>(texel);
}

// `place` in [0, 1].
template <Wrap wrap>
[[gnu::always_inline]] inline SlopeFootprint slope_footprint(float place, std::int32_t size) {
  const AxisFootprint found = plain_footprint(place, size);
  const bool is_late = found.weight >= 0.5f;
  const std::int32_t first = found.first - (is_late ? 0 : 1);
  return {
      {wrapped<wrap>(first, size), wrapped<wrap>(first + 1, size), wrapped<wrap>(first + 2, size)},
      is_late,
      found.weight,
      found.weight + (is_late ? -0.5f : 0.5f)};
}

[[gnu::always_inline]] inline float rise(float before, float middle, float behind,
                                         const SlopeFootprint& along) {
  return between(middle - before, behind - middle, along.slope_weight);
}

// At the place of which `lines` are beside each other.
[[gnu::always_inline]] inline float at_place(const float (&lines)[3],
                                             const SlopeFootprint& across) {
  return between(across.is_late ? lines[0] : lines[1], across.is_late ? lines[1] : lines[2],
                 across.weight);
}

template <SampleType type, int channels, bool is_srgb, Wrap wrap>
Vec2f slope(const TexelView& view, Vec2f uv) {
  constexpr auto placed = wrap == Wrap::Repeat ? fraction : clamped_to_unit;
  const SlopeFootprint columns = slope_footprint<wrap>(placed(uv.x), view.width);
  const SlopeFootprint rows = slope_footprint<wrap>(1 - placed(uv.y), view.height);
  float t[3][3];
  for (std::size_t y = 0; y < 3; ++y) {
    const std::byte* row = view.samples + rows.texels[y] * static_cast<std::size_t>(view.width) *
                                              channels * size_of(type);
    for (std::size_t x = 0; x < 3; ++x) {
      const std::byte* place = row + columns.texels[x] * channels * size_of(type);
      t[y][x] = is_srgb ? decoded<type, Encoding::Srgb>(place) : stored<type>(place);
    }
  }
  const float along_u[3] = {rise(t[0][0], t[0][1], t[0][2], columns),
                            rise(t[1][0], t[1][1], t[1][2], columns),
                            rise(t[2][0], t[2][1], t[2][2], columns)};
  const float downwards[3] = {rise(t[0][0], t[1][0], t[2][0], rows),
                              rise(t[0][1], t[1][1], t[2][1], rows),
                              rise(t[0][2], t[1][2], t[2][2], rows)};
  constexpr float one = is_srgb ? 1.0f : unit<type>;
  return {at_place(along_u, rows) * (static_cast<float>(view.width) / one),
          -at_place(downwards, columns) * (static_cast<float>(view.height) / one)};
}

template <SampleType type, int channels, Wrap wrap>
SlopeFilter chosen_encoding(Encoding encoding) {
  return encoding == Encoding::Srgb ? slope<type, channels, true, wrap>
                                    : slope<type, channels, false, wrap>;
}

}  // namespace

SlopeFilter slope_filter(SampleType type, int channels, Encoding encoding, Wrap wrap) {
  const bool is_power = encoding == Encoding::Gamma22 || encoding == Encoding::LabGamma;
  if (is_power || (wrap != Wrap::Repeat && wrap != Wrap::Clamp)) return nullptr;
  return with_format(type, channels, [&]<SampleType of_type, int of_channels>() {
    return wrap == Wrap::Repeat ? chosen_encoding<of_type, of_channels, Wrap::Repeat>(encoding)
                                : chosen_encoding<of_type, of_channels, Wrap::Clamp>(encoding);
  });
}

}  // namespace candela
