#include "renderer/image/encode.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <new>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "renderer/base/lack_of_threads.h"
#include "renderer/image/codecs.h"
#include "renderer/image/display_transform.h"
#include "renderer/image/encodable.h"
#include "renderer/image/formats/encode_exr.h"
#include "renderer/image/formats/encode_png.h"

namespace candela {
namespace {

// A picture for an encoder and, where they are not the image's own, its samples.
struct Prepared {
  Encodable picture;
  std::vector<std::uint8_t> bytes;
  std::vector<float> floats;
};

// Where an integer has no place it becomes decimal text, which is exact.
EncodableAttribute attribute_of(const std::string& name, const MetadataValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return {name, *text};
  if (const auto* number = std::get_if<double>(&value)) return {name, *number};
  const std::int64_t whole = std::get<std::int64_t>(value);
  const bool fits = whole >= std::numeric_limits<std::int32_t>::min() &&
                    whole <= std::numeric_limits<std::int32_t>::max();
  if (fits) return {name, static_cast<int>(whole)};
  return {name, std::to_string(whole)};
}

Prepared exr_of(const Image& image, const WriteOptions& options) {
  Prepared result;
  Encodable& picture = result.picture;
  picture.header = {image.width, image.height, SampleType::Float, image.channels};
  picture.header.left = options.offset_x;
  picture.header.top = options.offset_y;
  picture.full_width = options.full_width > 0 ? options.full_width : image.width;
  picture.full_height = options.full_height > 0 ? options.full_height : image.height;
  picture.samples = reinterpret_cast<const std::byte*>(image.values.data());
  return result;
}

// R G B, and A where it is there and `keep_alpha`.
std::vector<float> colour_values(const Image& image, bool keep_alpha) {
  const ColourChannels channels = colour_channels(image);
  const std::size_t count = keep_alpha && channels.alpha >= 0 ? 4 : 3;
  std::vector<float> values(image.pixel_count() * count);
  for (std::size_t i = 0; i < image.pixel_count(); ++i) {
    const float* pixel = image.values.data() + i * image.channel_count();
    for (std::size_t c = 0; c < 3; ++c) values[i * count + c] = pixel[channels.rgb[c]];
    if (count == 4) values[i * count + 3] = pixel[channels.alpha];
  }
  return values;
}

ImageHeader colour_header(const Image& image, std::size_t value_count, SampleType type) {
  ImageHeader header{image.width, image.height, type, {"R", "G", "B"}};
  if (value_count > 3 * image.pixel_count()) {
    header.channels.emplace_back("A");
    header.alpha_channel = 3;
  }
  return header;
}

Prepared of_floats(const Image& image, std::vector<float> values) {
  Prepared result;
  result.floats = std::move(values);
  result.picture.header = colour_header(image, result.floats.size(), SampleType::Float);
  result.picture.samples = reinterpret_cast<const std::byte*>(result.floats.data());
  return result;
}

Prepared of_bytes(const Image& image, const DisplayTransform& display, bool keep_alpha) {
  Prepared result;
  result.bytes = display_bytes(image, display, keep_alpha);
  result.picture.header = colour_header(image, result.bytes.size(), SampleType::U8);
  result.picture.samples = reinterpret_cast<const std::byte*>(result.bytes.data());
  return result;
}

Prepared tiff_of(const Image& image) {
  Prepared result = of_floats(image, colour_values(image, true));
  // Exif cannot be written in memory.
  result.picture.attributes = {{"compression", "zip"}, {"tiff:write_exif", 0}};
  return result;
}

// The nearest colour that RGBE holds, three bytes and the exponent of the largest channel, and a
// quarter of a step: encoders cut off what is below a step, readers add nothing.
void round_to_rgbe(float* rgb) {
  const float largest = std::max({rgb[0], rgb[1], rgb[2]});
  int exponent = 0;
  const float fraction = std::frexp(largest, &exponent);
  if (fraction * 256 >= 255.5f) ++exponent;
  const float step = std::ldexp(1.0f, exponent - 8);
  for (int c = 0; c < 3; ++c) rgb[c] = (std::round(rgb[c] / step) + 0.25f) * step;
}

// The four bytes of RGBE hold no negative, infinite or undefined number.
Prepared hdr_of(const Image& image) {
  constexpr float largest = 1e38f;  // RGBE ends at 2^127
  constexpr float least = 1e-32f;   // below which encoders write black
  std::vector<float> values = colour_values(image, false);
  for (float& value : values) value = std::isgreater(value, 0.0f) ? std::min(value, largest) : 0.0f;
  for (std::size_t i = 0; i < values.size(); i += 3)
    if (std::max({values[i], values[i + 1], values[i + 2]}) > least) round_to_rgbe(&values[i]);
  return of_floats(image, std::move(values));
}

Prepared png_of(const Image& image, const WriteOptions& options) {
  Prepared result = of_bytes(image, options.display, true);
  result.picture.header.alpha_is_straight = true;
  if (options.display.tone_map != ToneMap::Lab3)
    result.picture.attributes = {{"oiio:ColorSpace", "sRGB"}};
  return result;
}

Prepared jpeg_of(const Image& image, const WriteOptions& options) {
  Prepared result = of_bytes(image, options.display, false);
  result.picture.attributes = {{"CompressionQuality", 95}, {"jpeg:subsampling", "4:4:4"}};
  return result;
}

Prepared without_metadata(ImageFormat format, const Image& image, const WriteOptions& options) {
  switch (format) {
    case ImageFormat::Exr:
      return exr_of(image, options);
    case ImageFormat::Png:
      return png_of(image, options);
    case ImageFormat::Jpeg:
      return jpeg_of(image, options);
    case ImageFormat::Hdr:
      return hdr_of(image);
    case ImageFormat::Tiff:
      return tiff_of(image);
    case ImageFormat::Bmp:
    case ImageFormat::Tga:
    case ImageFormat::Pnm:
      break;
  }
  return {};
}

// Only OpenEXR holds all metadata, but OpenImageIO notes the time of day in other formats, too,
// where none is given.
Prepared prepared(ImageFormat format, const Image& image, const WriteOptions& options) {
  Prepared result = without_metadata(format, image, options);
  for (const auto& [name, value] : options.metadata)
    if (format == ImageFormat::Exr || name == "DateTime")
      result.picture.attributes.push_back(attribute_of(name, value));
  return result;
}

// Sides that a format's library refuses in ways of its own (libjpeg calls exit()).
int longest_side(ImageFormat format) {
  if (format == ImageFormat::Jpeg) return 65500;
  if (format == ImageFormat::Png) return 1000000;
  return std::numeric_limits<int>::max() / 64;
}

Diagnostics check_channels(const std::vector<std::string>& names) {
  std::set<std::string_view> seen;
  for (const std::string& name : names) {
    if (name.empty()) return failure("the picture has a channel without a name");
    if (!seen.insert(name).second)
      return failure(fmt::format("the picture has two channels '{}'", name));
  }
  return {};
}

Diagnostics check_encodable(ImageFormat format, const Image& image) {
  if (!is_writable(format))
    return failure(fmt::format("{} files are read but not written", name_of(format)));
  if (image.width <= 0 || image.height <= 0 || image.channels.empty())
    return failure("the picture is empty");
  if (image.values.size() != image.pixel_count() * image.channel_count())
    return failure("the picture's values do not fit its size");
  if (Diagnostics found = check_channels(image.channels); found.has_errors()) return found;
  return check_sides(format, image.width, image.height);
}

Diagnostics encoder_failure(ImageFormat format, const std::string& reason) {
  return failure(fmt::format("{} encoder: {}", name_of(format), reason));
}

Result<std::string> encode_by_codecs(ImageFormat format, const Encodable& image) {
  const Result<Codecs> others = codecs();
  if (!others) return others.diagnostics;
  try {
    return others->encode(format, image);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& exception) {
    if (is_lack_of_threads(exception)) throw;
    return failure(exception.what());
  }
}

Result<std::string> encode_as(ImageFormat format, const Encodable& image) {
  if (is_encoded_by_codecs(format)) return encode_by_codecs(format, image);
  return format == ImageFormat::Exr ? encode_exr(image) : encode_png(image);
}

Result<std::string> encode(ImageFormat format, const Encodable& image) {
  Result<std::string> bytes = encode_as(format, image);
  if (bytes) return bytes;
  return encoder_failure(format, bytes.diagnostics.list()[0].message);
}

std::vector<std::byte> one_channel(const DecodedImage& image, std::size_t channel) {
  const std::size_t bytes = size_of(image.header.sample_type);
  const std::size_t stride = bytes * image.header.channels.size();
  const std::size_t pixels = image.header.sample_count() / image.header.channels.size();
  std::vector<std::byte> samples(pixels * bytes);
  for (std::size_t i = 0; i < pixels; ++i)
    std::copy_n(image.samples.get() + i * stride + channel * bytes, bytes,
                samples.data() + i * bytes);
  return samples;
}

}  // namespace

Diagnostics check_sides(ImageFormat format, int width, int height) {
  const int limit = longest_side(format);
  if (width <= limit && height <= limit) return {};
  return failure(fmt::format("a {} can be at most {} pixels wide and high, not {} x {}",
                             name_of(format), limit, width, height));
}

bool is_encoded_by_codecs(ImageFormat format) {
  return format != ImageFormat::Exr && format != ImageFormat::Png;
}

Result<std::string> encode_samples(const DecodedImage& image, int channel) {
  const ImageHeader& header = image.header;
  const bool is_float =
      header.sample_type == SampleType::Half || header.sample_type == SampleType::Float;
  const ImageFormat format = is_float ? ImageFormat::Exr : ImageFormat::Png;
  const auto count = static_cast<int>(header.channels.size());
  if (channel >= count) return failure(fmt::format("it has no channel {}", channel));
  if (!is_float && std::max(header.width, header.height) > longest_side(format))
    return failure("it is too large for a png");
  Encodable result;
  result.header = header;
  result.header.left = result.header.top = 0;
  result.header.alpha_is_straight = true;
  result.full_width = header.width;
  result.full_height = header.height;
  result.attributes = {{"DateTime", "2000:01:01 00:00:00"}};  // the same samples, the same bytes
  result.samples = image.samples.get();
  std::vector<std::byte> picked;
  if (channel >= 0) {
    picked = one_channel(image, static_cast<std::size_t>(channel));
    result.header.channels = {"Y"};
    result.header.alpha_channel = -1;
    result.samples = picked.data();
  }
  return encode(format, result);
}

Result<std::string> encode_image(ImageFormat format, const Image& image,
                                 const WriteOptions& options) {
  if (Diagnostics found = check_encodable(format, image); found.has_errors()) return found;
  return encode(format, prepared(format, image, options).picture);
}

}  // namespace candela
