#include "renderer/texture/texels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include <fmt/format.h>

#include "renderer/base/thread_clock.h"
#include "renderer/texture/sample_value.h"

namespace candela {
namespace {

// Infinities of half-float maps (a sun that was too bright) become the largest half.
constexpr float largest_half = 65504;

// Of a file's channels the leading ones that make grey, grey and alpha, RGB or RGBA.
int useful_channels(const ImageHeader& header) {
  const int count = std::min(static_cast<int>(header.channels.size()), 4);
  const bool ends_in_alpha = header.alpha_channel == count - 1;
  return count % 2 == 0 && !ends_in_alpha ? count - 1 : count;
}

float finite_value(float value) {
  if (std::isnan(value)) return 0;
  return std::copysign(largest_half, value);
}

template <class Sample>
std::size_t remove_negative_samples(TexelArray& texels) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < texels.bytes() / sizeof(Sample); ++i) {
    std::byte* const place = texels.samples.get() + i * sizeof(Sample);
    bool is_negative = false;
    if constexpr (std::is_same_v<Sample, float>)
      is_negative = value_at<float>(place) < 0;
    else
      is_negative = value_at<std::uint16_t>(place) > 0x8000u;  // but for -0
    if (!is_negative) continue;
    constexpr Sample zero{};
    std::memcpy(place, &zero, sizeof(zero));
    ++count;
  }
  return count;
}

// Replaces what is not finite and returns how many there were.
std::size_t remove_non_finite(TexelArray& texels) {
  std::size_t count = 0;
  const std::size_t samples = texels.bytes() / size_of(texels.type);
  for (std::size_t i = 0; i < samples; ++i) {
    std::byte* place = texels.samples.get() + i * size_of(texels.type);
    if (texels.type == SampleType::Half) {
      const auto half = value_at<std::uint16_t>(place);
      if ((half & 0x7C00u) != 0x7C00u) continue;
      const bool is_nan = (half & 0x3FFu) != 0;
      const auto largest = static_cast<std::uint16_t>((half & 0x8000u) | 0x7BFFu);
      const std::uint16_t replaced = is_nan ? std::uint16_t{0} : largest;
      std::memcpy(place, &replaced, sizeof(replaced));
    } else {
      const auto value = value_at<float>(place);
      if (std::isfinite(value)) continue;
      const float replaced = finite_value(value);
      std::memcpy(place, &replaced, sizeof(replaced));
    }
    ++count;
  }
  return count;
}

}  // namespace

float stored_value(const TexelArray& texels, int x, int y, int channel) {
  const std::size_t index = (static_cast<std::size_t>(y) * static_cast<std::size_t>(texels.width) +
                             static_cast<std::size_t>(x)) *
                                static_cast<std::size_t>(texels.channels) +
                            static_cast<std::size_t>(channel);
  const std::byte* place = texels.samples.get() + index * size_of(texels.type);
  return with_format(texels.type, 1,
                     [&]<SampleType type, int>() { return stored<type>(place) / unit<type>; });
}

bool is_opaque(const TexelArray& texels) {
  for (int y = 0; y < texels.height; ++y)
    for (int x = 0; x < texels.width; ++x)
      if (stored_value(texels, x, y, texels.channels - 1) != 1) return false;
  return true;
}

bool is_grey(const TexelArray& texels) {
  if (texels.channels < 3) return true;
  const std::size_t size = size_of(texels.type);
  const std::size_t texel_size = static_cast<std::size_t>(texels.channels) * size;
  for (std::size_t at = 0; at < texels.bytes(); at += texel_size) {
    const std::byte* texel = texels.samples.get() + at;
    if (std::memcmp(texel, texel + size, size) != 0) return false;
    if (std::memcmp(texel, texel + 2 * size, size) != 0) return false;
  }
  return true;
}

TextureFile::TextureFile(std::string path, SourceSpan span, const Result<ImageHeader>& found,
                         bool is_light)
    : path_(std::move(path)), span_(std::move(span)), is_broken_(!found), is_light_(is_light) {
  if (is_broken_) {
    complaint_ = found.diagnostics.list()[0].message;
    return;
  }
  width_ = found->width;
  height_ = found->height;
  channels_ = useful_channels(*found);
  type_ = found->sample_type;
}

TextureFile::TextureFile(std::string name, TexelArray texels)
    : path_(std::move(name)),
      width_(texels.width),
      height_(texels.height),
      channels_(texels.channels),
      type_(texels.type) {
  std::call_once(decode_once_, [&] { texels_ = std::move(texels); });
  is_decoded_.store(true, std::memory_order_release);
}

std::size_t TextureFile::bytes() const {
  return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) *
         static_cast<std::size_t>(channels_) * size_of(type_);
}

const TexelArray& TextureFile::texels() {
  std::call_once(decode_once_, [this] { decode(); });
  return texels_;
}

void TextureFile::decode() {
  const double start = thread_cpu_seconds();
  if (is_broken_)
    become_magenta();
  else
    decode_file();
  decoding_seconds_ = thread_cpu_seconds() - start;
  is_decoded_.store(true, std::memory_order_release);
}

void TextureFile::decode_file() {
  DecodeLimits limits;
  limits.max_channels = static_cast<std::size_t>(channels_);
  Result<DecodedImage> image = read_decoded_image(path_, limits);
  for (const Diagnostic& found : image.diagnostics.list())
    diagnostics_.warning(
        span_, fmt::format("texture {}{}", found.message, image ? "" : "; it is magenta"));
  if (!image) {
    complaint_ = image.diagnostics.list()[0].message;
    return become_magenta();
  }
  texels_.width = image->header.width;
  texels_.height = image->header.height;
  texels_.channels = static_cast<int>(image->header.channels.size());
  texels_.type = image->header.sample_type;
  texels_.samples = std::move(image->samples);
  if (texels_.type != SampleType::Half && texels_.type != SampleType::Float) return;
  if (const std::size_t count = remove_non_finite(texels_); count > 0)
    diagnostics_.warning(span_, fmt::format("texture '{}' holds {} values that are not finite; NaN "
                                            "counts as 0, infinity as {}",
                                            path_, count, largest_half));
  if (is_light_) remove_negative();
}

void TextureFile::remove_negative() {
  std::size_t count = 0;
  if (texels_.type == SampleType::Half) count = remove_negative_samples<std::uint16_t>(texels_);
  if (texels_.type == SampleType::Float) count = remove_negative_samples<float>(texels_);
  if (count > 0)
    diagnostics_.warning(span_, fmt::format("texture '{}' holds {} values below 0, which are no "
                                            "light: they count as 0",
                                            path_, count));
}

void TextureFile::become_magenta() {
  constexpr std::array<unsigned char, 4> magenta{255, 0, 255, 255};
  is_broken_ = true;
  texels_ = {};
  texels_.channels = 4;
  texels_.samples = std::make_shared_for_overwrite<std::byte[]>(magenta.size());
  std::memcpy(texels_.samples.get(), magenta.data(), magenta.size());
}

float TextureFile::largest() {
  if (!holds_floats()) return 1;
  const TexelArray& array = texels();
  if (is_broken_) return 1;
  const bool is_half = array.type == SampleType::Half;
  float largest = 0;
  for (std::size_t i = 0; i < array.bytes() / size_of(array.type); ++i) {
    const std::byte* const place = array.samples.get() + i * size_of(array.type);
    largest = std::max(
        largest, is_half ? half_to_float(value_at<std::uint16_t>(place)) : value_at<float>(place));
  }
  return largest;
}

Diagnostics TextureFile::decoding_diagnostics() const {
  return is_decoded() ? diagnostics_ : Diagnostics{};
}

const RangeTree& TextureFile::range_tree(int channel) {
  const TexelArray& array = texels();
  const auto index = static_cast<std::size_t>(channel);
  std::call_once(range_once_[index], [&] {
    range_trees_[index] = RangeTree(array.width, array.height, [&](int x, int y) {
      return stored_value(array, x, y, channel);
    });
  });
  return range_trees_[index];
}

}  // namespace candela
