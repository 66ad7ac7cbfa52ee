#include <cstring>

#include "renderer/image/decode.h"
#include "renderer/image/half.h"
#include "renderer/image/image_io.h"
#include "renderer/image/value_at.h"
#include "renderer/math/colour.h"

namespace candela {
namespace {

// Integers 0..max as [0,1], decoded or as they stand.
std::vector<float> value_table(int max, bool is_srgb) {
  std::vector<float> table(static_cast<std::size_t>(max) + 1);
  for (int i = 0; i <= max; ++i) {
    const double value = static_cast<double>(i) / max;
    table[static_cast<std::size_t>(i)] =
        static_cast<float>(is_srgb ? srgb_to_linear(value) : value);
  }
  return table;
}

template <class Integer>
void decode_integers(const DecodedImage& source, std::vector<float>& values) {
  constexpr int max = std::numeric_limits<Integer>::max();
  const std::vector<float> colour = value_table(max, true);
  const std::vector<float> plain = value_table(max, false);
  const std::size_t channels = source.header.channels.size();
  for (std::size_t c = 0; c < channels; ++c) {
    const auto& table = static_cast<int>(c) == source.header.alpha_channel ? plain : colour;
    for (std::size_t i = c; i < values.size(); i += channels)
      values[i] = table[value_at<Integer>(source.samples.get() + i * sizeof(Integer))];
  }
}

void decode_samples(const DecodedImage& source, std::vector<float>& values) {
  switch (source.header.sample_type) {
    case SampleType::U8:
      return decode_integers<std::uint8_t>(source, values);
    case SampleType::U16:
      return decode_integers<std::uint16_t>(source, values);
    case SampleType::Half:
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = half_to_float(
            value_at<std::uint16_t>(source.samples.get() + i * sizeof(std::uint16_t)));
      return;
    case SampleType::Float:
      std::memcpy(values.data(), source.samples.get(), values.size() * sizeof(float));
      return;
  }
}

void premultiply(Image& image, std::size_t alpha) {
  const std::size_t channels = image.channel_count();
  for (std::size_t i = 0; i < image.values.size(); i += channels)
    for (std::size_t c = 0; c < channels; ++c)
      if (c != alpha) image.values[i + c] *= image.values[i + alpha];
}

}  // namespace

Result<Image> read_image(const std::string& path, std::size_t max_bytes) {
  DecodeLimits limits;
  limits.max_bytes = max_bytes;
  limits.counts_floats = true;
  Result<DecodedImage> decoded = read_decoded_image(path, limits);
  if (!decoded) return decoded.diagnostics;
  Image image(decoded->header.width, decoded->header.height, decoded->header.channels);
  decode_samples(*decoded, image.values);
  const int alpha = decoded->header.alpha_channel;
  if (alpha >= 0 && decoded->header.alpha_is_straight)
    premultiply(image, static_cast<std::size_t>(alpha));
  return {std::move(image), std::move(decoded.diagnostics)};
}

}  // namespace candela
