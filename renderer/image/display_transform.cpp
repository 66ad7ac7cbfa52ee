#include "renderer/image/display_transform.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/parallel.h"
#include "renderer/math/colour.h"

namespace candela {
namespace {

// The rational fit to the ACES filmic curve [Narkowicz15]. Its limit is 2.51 / 2.43, above 1.
double aces_curve(double x) {
  constexpr double limit = 1e6;  // beyond it the squares would overflow for no other result
  x = std::min(x, limit);
  return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
}

double encoded(double linear, ToneMap tone_map) {
  switch (tone_map) {
    case ToneMap::Srgb:
      return linear_to_srgb(std::min(linear, 1.0));
    case ToneMap::Aces:
      return linear_to_srgb(std::min(aces_curve(linear), 1.0));
    case ToneMap::Lab3:
      return std::pow(linear, 1 / 2.2);
  }
  return 0;
}

std::uint8_t rounded_to_8_bits(double value) {
  return static_cast<std::uint8_t>(std::min(value, 1.0) * 255 + 0.5);
}

void convert_pixel(const float* pixel, const ColourChannels& channels,
                   const DisplayTransform& display, bool keep_alpha, std::uint8_t* out) {
  const float alpha = keep_alpha ? pixel[channels.alpha] : 1.0f;
  const double scale = alpha > 0 ? 1.0 / static_cast<double>(alpha) : 1.0;
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = display_value(static_cast<double>(pixel[channels.rgb[c]]) * scale, display);
  if (keep_alpha) out[3] = alpha > 0 ? rounded_to_8_bits(static_cast<double>(alpha)) : 0;
}

}  // namespace

std::uint8_t display_value(double linear, const DisplayTransform& display) {
  const double exposed = linear * std::exp2(display.exposure);
  if (!std::isgreater(exposed, 0.0)) return 0;
  return rounded_to_8_bits(encoded(exposed, display.tone_map));
}

ColourChannels colour_channels(const Image& image) {
  ColourChannels channels;
  channels.alpha = image.channel_index("A");
  if (image.channel_index("R") < 0) return channels;
  const char* const names[3] = {"R", "G", "B"};
  for (std::size_t c = 0; c < 3; ++c) channels.rgb[c] = std::max(image.channel_index(names[c]), 0);
  return channels;
}

std::vector<std::uint8_t> display_bytes(const Image& image, const DisplayTransform& display,
                                        bool keep_alpha) {
  const ColourChannels channels = colour_channels(image);
  const bool has_alpha = keep_alpha && channels.alpha >= 0;
  const std::size_t stride = has_alpha ? 4 : 3;
  std::vector<std::uint8_t> bytes(image.pixel_count() * stride);
  constexpr std::size_t grain = 4096;
  parallel_for_chunks(image.pixel_count(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      convert_pixel(image.values.data() + i * image.channel_count(), channels, display, has_alpha,
                    bytes.data() + i * stride);
  });
  return bytes;
}

}  // namespace candela
