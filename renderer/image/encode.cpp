#include "renderer/image/encode.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <exception>
#include <limits>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "renderer/base/floating_point_traps.h"
#include "renderer/image/display_transform.h"
#include "renderer/image/openimageio_setup.h"
#include "renderer/image/sample_type.h"

namespace candela {
namespace {

using OIIO::ImageSpec;
using OIIO::TypeDesc;

// What is handed to OpenImageIO: a description and interleaved rows of it.
struct Encodable {
  ImageSpec spec;
  std::vector<std::uint8_t> bytes;
  std::vector<float> floats;
  const std::byte* samples = nullptr;  // in place of both
  [[nodiscard]] const void* data() const {
    if (samples) return samples;
    return bytes.empty() ? static_cast<const void*>(floats.data()) : bytes.data();
  }
};

// OpenEXR has no 64-bit integers: they become decimal text, which is exact.
void add_metadata(ImageSpec& spec, const std::string& name, const MetadataValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) {
    spec.attribute(name, *text);
  } else if (const auto* number = std::get_if<double>(&value)) {
    spec.attribute(name, TypeDesc::DOUBLE, number);
  } else {
    const std::int64_t whole = std::get<std::int64_t>(value);
    const bool fits = whole >= std::numeric_limits<std::int32_t>::min() &&
                      whole <= std::numeric_limits<std::int32_t>::max();
    if (fits)
      spec.attribute(name, static_cast<int>(whole));
    else
      spec.attribute(name, std::to_string(whole));
  }
}

Encodable exr_of(const Image& image, const WriteOptions& options) {
  Encodable result;
  ImageSpec spec(image.width, image.height, static_cast<int>(image.channel_count()),
                 TypeDesc::FLOAT);
  spec.channelnames = image.channels;
  spec.alpha_channel = image.channel_index("A");
  spec.z_channel = image.channel_index("Z");
  spec.x = options.offset_x;
  spec.y = options.offset_y;
  spec.full_x = 0;
  spec.full_y = 0;
  spec.full_width = options.full_width > 0 ? options.full_width : image.width;
  spec.full_height = options.full_height > 0 ? options.full_height : image.height;
  spec.attribute("compression", "zip");
  spec.attribute("oiio:ColorSpace", "Linear");
  result.spec = std::move(spec);
  result.floats = image.values;
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

ImageSpec colour_spec(const Image& image, std::size_t value_count, TypeDesc type) {
  const std::size_t channels = value_count / std::max<std::size_t>(image.pixel_count(), 1);
  return {image.width, image.height, static_cast<int>(channels), type};
}

Encodable tiff_of(const Image& image) {
  Encodable result;
  result.floats = colour_values(image, true);
  result.spec = colour_spec(image, result.floats.size(), TypeDesc::FLOAT);
  result.spec.attribute("compression", "zip");
  result.spec.attribute("tiff:write_exif", 0);  // which cannot be written in memory
  return result;
}

// The four bytes of RGBE hold no negative, infinite or undefined number.
Encodable hdr_of(const Image& image) {
  constexpr float largest = 1e38f;  // RGBE ends at 2^127
  Encodable result;
  result.floats = colour_values(image, false);
  for (float& value : result.floats)
    value = std::isgreater(value, 0.0f) ? std::min(value, largest) : 0.0f;
  result.spec = colour_spec(image, result.floats.size(), TypeDesc::FLOAT);
  return result;
}

Encodable png_of(const Image& image, const WriteOptions& options) {
  Encodable result;
  result.bytes = display_bytes(image, options.display, true);
  result.spec = colour_spec(image, result.bytes.size(), TypeDesc::UINT8);
  result.spec.attribute("oiio:UnassociatedAlpha", 1);
  if (options.display.tone_map != ToneMap::Lab3) result.spec.attribute("oiio:ColorSpace", "sRGB");
  return result;
}

Encodable jpeg_of(const Image& image, const WriteOptions& options) {
  Encodable result;
  result.bytes = display_bytes(image, options.display, false);
  result.spec = colour_spec(image, result.bytes.size(), TypeDesc::UINT8);
  result.spec.attribute("CompressionQuality", 95);
  result.spec.attribute("jpeg:subsampling", "4:4:4");
  return result;
}

Encodable without_metadata(ImageFormat format, const Image& image, const WriteOptions& options) {
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
Encodable encodable(ImageFormat format, const Image& image, const WriteOptions& options) {
  Encodable result = without_metadata(format, image, options);
  for (const auto& [name, value] : options.metadata)
    if (format == ImageFormat::Exr || name == "DateTime") add_metadata(result.spec, name, value);
  return result;
}

// Sides that a format's library refuses in ways of its own (libjpeg calls exit()).
int longest_side(ImageFormat format) {
  if (format == ImageFormat::Jpeg) return 65500;
  if (format == ImageFormat::Png) return 1000000;
  return std::numeric_limits<int>::max() / 64;
}

Diagnostics check_encodable(ImageFormat format, const Image& image) {
  if (!is_writable(format))
    return failure(fmt::format("{} files are read but not written", name_of(format)));
  if (image.width <= 0 || image.height <= 0 || image.channels.empty())
    return failure("the picture is empty");
  if (image.values.size() != image.pixel_count() * image.channel_count())
    return failure("the picture's values do not fit its size");
  return check_sides(format, image.width, image.height);
}

Diagnostics encoder_failure(ImageFormat format, const std::string& reason) {
  return failure(fmt::format("{} encoder: {}", name_of(format), reason));
}

Result<std::string> encode(ImageFormat format, const Encodable& image) {
  const FloatingPointTraps traps(Traps::Off);
  const std::string name(name_of(format));
  const auto output = OIIO::ImageOutput::create(name);
  if (!output) return encoder_failure(format, OIIO::geterror());
  std::vector<unsigned char> buffer;
  OIIO::Filesystem::IOVecOutput memory(buffer);
  if (!output->supports("ioproxy") || !output->set_ioproxy(&memory))
    return encoder_failure(format, "cannot encode in memory");
  const bool is_done = output->open("memory." + name, image.spec) &&
                       output->write_image(image.spec.format, image.data()) && output->close();
  if (!is_done || output->has_error()) return encoder_failure(format, output->geterror());
  return std::string(buffer.begin(), buffer.end());
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

Result<std::string> encode_samples(const DecodedImage& image, int channel) {
  const ImageHeader& header = image.header;
  const bool is_float =
      header.sample_type == SampleType::Half || header.sample_type == SampleType::Float;
  const ImageFormat format = is_float ? ImageFormat::Exr : ImageFormat::Png;
  const auto count = static_cast<int>(header.channels.size());
  if (channel >= count) return failure(fmt::format("it has no channel {}", channel));
  if (!is_float && std::max(header.width, header.height) > longest_side(format))
    return failure("it is too large for a png");
  try {
    set_up_openimageio();
    std::vector<std::byte> picked;
    Encodable result;
    result.spec = ImageSpec(header.width, header.height, channel < 0 ? count : 1,
                            type_desc_of(header.sample_type));
    result.samples = image.samples.get();
    if (channel < 0) {
      result.spec.channelnames = header.channels;
      result.spec.alpha_channel = header.alpha_channel;
    } else {
      picked = one_channel(image, static_cast<std::size_t>(channel));
      result.spec.channelnames = {"Y"};
      result.samples = picked.data();
    }
    result.spec.attribute("compression", "zip");
    result.spec.attribute("oiio:UnassociatedAlpha", 1);
    result.spec.attribute("DateTime", "2000:01:01 00:00:00");  // the same samples, the same bytes
    return encode(format, result);
  } catch (const std::exception& exception) {
    return encoder_failure(format, exception.what());
  }
}

Result<std::string> encode_image(ImageFormat format, const Image& image,
                                 const WriteOptions& options) {
  if (Diagnostics found = check_encodable(format, image); found.has_errors()) return found;
  try {
    set_up_openimageio();
    return encode(format, encodable(format, image, options));
  } catch (const std::exception& exception) {
    return encoder_failure(format, exception.what());
  }
}

}  // namespace candela
