#include "renderer/image/decode.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <mutex>
#include <new>

#include <fmt/format.h>

#include "renderer/base/floating_point_traps.h"
#include "renderer/base/large_pages.h"
#include "renderer/image/guard.h"
#include "renderer/image/image_format.h"
#include "renderer/image/jpeg_header.h"
#include "renderer/image/openimageio_setup.h"
#include "renderer/image/sample_type.h"
#include "renderer/image/tga.h"

namespace candela {

void set_up_openimageio() {
  static std::once_flag once;
  std::call_once(once, [] {
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1);  // -1: OpenEXR's pool stays empty, the caller works
    OIIO::attribute("try_all_readers", 0);
  });
}

namespace {

using OIIO::ImageSpec;
using OIIO::TypeDesc;

// Rows that are decoded at once: a multiple of every EXR compression's block of lines.
constexpr int band_rows = 256;
// Above any ratio of TIFF's compressions but that of blank fax pages.
constexpr double best_tiff_compression = 2000;

std::string_view reader_of(ImageFormat format) {
  return format == ImageFormat::Tga ? "targa" : name_of(format);
}

// One line of what OpenImageIO says, which may be several and may end with the file's bare name.
std::string first_line(const std::string& text) {
  return text.empty() ? "its reader gave no reason" : text.substr(0, text.find('\n'));
}

// A file in memory. OpenImageIO's own lets files that point before their beginning be read there.
class FileInMemory final : public OIIO::Filesystem::IOMemReader {
 public:
  explicit FileInMemory(const Bytes& bytes) : IOMemReader(bytes.data(), bytes.size()) {}

  std::size_t pread(void* out, std::size_t size, std::int64_t offset) override {
    return holds(offset) ? IOMemReader::pread(out, size, offset) : 0;
  }
  std::size_t read(void* out, std::size_t size) override {
    return holds(tell()) ? IOMemReader::read(out, size) : 0;
  }

 private:
  [[nodiscard]] bool holds(std::int64_t offset) {
    return offset >= 0 && static_cast<std::uint64_t>(offset) <= this->size();
  }
};

// An image file that is open in OpenImageIO, and the bytes it lies in.
struct OpenImage {
  Bytes bytes;
  ImageFormat format = ImageFormat::Png;
  std::unique_ptr<FileInMemory> memory;
  std::unique_ptr<OIIO::ImageInput> input;
  ImageSpec spec;
};

std::optional<ImageFormat> format_of(const std::string& name, const Bytes& bytes) {
  if (const auto found = format_of_bytes(bytes)) return found;
  if (format_of_extension(name) == ImageFormat::Tga) return ImageFormat::Tga;
  return std::nullopt;
}

Diagnostics check_size(double width, double height, double channels, SampleType type,
                       const DecodeLimits& limits) {
  if (width > limits.max_side || height > limits.max_side)
    return failure(fmt::format("claims {:.0f} x {:.0f} pixels; a side of at most {} is read", width,
                               height, limits.max_side));
  const std::size_t sample_bytes = size_of(limits.counts_floats ? SampleType::Float : type);
  const double kept_channels = std::min(channels, static_cast<double>(limits.max_channels));
  const double bytes = width * height * kept_channels * static_cast<double>(sample_bytes);
  if (bytes <= static_cast<double>(limits.max_bytes)) return {};
  return failure(
      fmt::format("claims {:.0f} x {:.0f} pixels: {:.0f} MB, where at most {:.0f} are read", width,
                  height, bytes / 1e6, static_cast<double>(limits.max_bytes) / 1e6));
}

Diagnostics check_spec(const OpenImage& image, const DecodeLimits& limits) {
  const ImageSpec& spec = image.spec;
  if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0)
    return failure("claims no pixels");
  if (spec.deep || spec.depth > 1) return failure("is a deep or volume image; flat ones are read");
  const double raw_bytes = static_cast<double>(spec.image_bytes(true));
  const double stored_bytes = static_cast<double>(image.bytes.size()) + 1024;
  if (image.format == ImageFormat::Tiff && raw_bytes > best_tiff_compression * stored_bytes)
    return failure(fmt::format("claims {} x {} pixels, which its {} bytes cannot hold", spec.width,
                               spec.height, image.bytes.size()));
  return check_size(spec.width, spec.height, spec.nchannels, sample_type_of(spec.format), limits);
}

Result<OpenImage> open_image(ImageFormat format, Bytes bytes, const DecodeLimits& limits) {
  set_up_openimageio();
  OpenImage image;
  image.format = format;
  image.bytes = std::move(bytes);
  image.memory = std::make_unique<FileInMemory>(image.bytes);
  image.input = OIIO::ImageInput::create(std::string(reader_of(format)));
  if (!image.input || !image.input->set_ioproxy(image.memory.get()))
    return failure(fmt::format("needs a {} reader, which OpenImageIO lacks", name_of(format)));
  ImageSpec hints;
  hints.attribute("oiio:UnassociatedAlpha", 1);
  if (!image.input->open(fmt::format("image.{}", name_of(format)), image.spec, hints))
    return failure(fmt::format("is no {} image that can be read: {}", name_of(format),
                               first_line(image.input->geterror())));
  if (Diagnostics found = check_spec(image, limits); found.has_errors()) return found;
  return image;
}

ImageHeader header_of(const OpenImage& image, const DecodeLimits& limits) {
  const ImageSpec& spec = image.spec;
  ImageHeader header;
  header.width = spec.width;
  header.height = spec.height;
  header.left = spec.x;
  header.top = spec.y;
  header.sample_type = sample_type_of(spec.format);
  header.channels = spec.channelnames;
  header.channels.resize(std::min<std::size_t>(header.channels.size(), limits.max_channels));
  const int alpha = spec.alpha_channel;
  header.alpha_channel = alpha < static_cast<int>(header.channels.size()) ? alpha : -1;
  header.alpha_is_straight =
      image.format != ImageFormat::Exr &&
      (image.format != ImageFormat::Tiff || spec.get_int_attribute("oiio:UnassociatedAlpha") != 0);
  return header;
}

void warn_of_inks(const OpenImage& image, Diagnostics& diagnostics) {
  for (const char* const attribute : {"jpeg:ColorSpace", "tiff:ColorSpace"}) {
    const std::string space(image.spec.get_string_attribute(attribute));
    if (space == "CMYK" || space == "YCbCrK" || space == "YCCK" || space == "color separated")
      diagnostics.warning({}, "holds printing inks (CMYK), converted to RGB without a profile");
  }
}

bool read_band(OpenImage& image, const ImageHeader& header, int row, int end, std::byte* out) {
  const ImageSpec& spec = image.spec;
  const TypeDesc type = type_desc_of(header.sample_type);
  const int channels = static_cast<int>(header.channels.size());
  const bool is_native =
      channels == spec.nchannels && type == spec.format && spec.channelformats.empty();
  // Straight to their place: read_scanlines() takes a detour even where nothing is to be converted.
  if (is_native)
    return image.input->read_native_scanlines(0, 0, spec.y + row, spec.y + end, 0, out);
  return image.input->read_scanlines(0, 0, spec.y + row, spec.y + end, 0, 0, channels, type, out);
}

bool read_rows(OpenImage& image, const ImageHeader& header, std::byte* out) {
  if (image.spec.tile_width > 0)
    return image.input->read_image(0, 0, 0, static_cast<int>(header.channels.size()),
                                   type_desc_of(header.sample_type), out);
  const std::size_t row_bytes =
      header.sample_count() / static_cast<std::size_t>(header.height) * size_of(header.sample_type);
  for (int row = 0; row < header.height; row += band_rows) {
    const int end = std::min(row + band_rows, header.height);
    if (!read_band(image, header, row, end, out + static_cast<std::size_t>(row) * row_bytes))
      return false;
  }
  return true;
}

// Some readers fill in what is missing, report success and leave a complaint behind: libtiff's for
// any damage, libjpeg's for damage that it can pass over too.
Diagnostics complaint_of(const OpenImage& image, const std::string& text) {
  if (text.empty()) return {};
  const bool is_passable =
      image.format == ImageFormat::Jpeg && text.find("Premature end") == std::string::npos;
  if (!is_passable) return failure(fmt::format("is damaged: {}", first_line(text)));
  Diagnostics found;
  found.warning({}, fmt::format("is damaged but readable: {}", first_line(text)));
  return found;
}

Result<DecodedImage> decode_open_image(OpenImage& image, const DecodeLimits& limits) {
  DecodedImage decoded;
  decoded.header = header_of(image, limits);
  decoded.samples = allocate_samples(decoded.header);
  const bool is_read = read_rows(image, decoded.header, decoded.samples.get());
  const std::string complaint = image.input->geterror();
  if (!is_read) return failure(fmt::format("is damaged: {}", first_line(complaint)));
  Diagnostics found = complaint_of(image, complaint);
  if (found.has_errors()) return found;
  warn_of_inks(image, found);
  return {std::move(decoded), std::move(found)};
}

// Puts the image's name before each message.
Diagnostics named(const std::string& name, const Diagnostics& found) {
  Diagnostics result;
  for (Diagnostic diagnostic : found.list()) {
    diagnostic.message = fmt::format("'{}' {}", name, diagnostic.message);
    result.add(std::move(diagnostic));
  }
  return result;
}

template <class T>
Result<T> named(const std::string& name, Result<T> result) {
  result.diagnostics = named(name, result.diagnostics);
  return result;
}

Result<ImageHeader> within(const DecodeLimits& limits, ImageHeader header) {
  const Diagnostics found =
      check_size(header.width, header.height, static_cast<double>(header.channels.size()),
                 header.sample_type, limits);
  if (found.has_errors()) return found;
  return header;
}

Result<ImageHeader> checked_tga_header(const Bytes& bytes, const DecodeLimits& limits) {
  Result<ImageHeader> header = decode_tga_header(bytes);
  if (!header) return header;
  return within(limits, std::move(*header));
}

Result<DecodedImage> checked_tga(const Bytes& bytes, const DecodeLimits& limits) {
  const Result<ImageHeader> header = checked_tga_header(bytes, limits);
  if (!header) return header.diagnostics;
  return decode_tga(bytes);
}

// Recognises, guards and hands on to `decode_tga_file` or, with the format, to `decode_other`.
template <class T, class DecodeTga, class DecodeOther>
Result<T> dispatch(const std::string& name, Bytes bytes, DecodeTga&& decode_tga_file,
                   DecodeOther&& decode_other) {
  if (!format_of_extension(name))
    return failure(fmt::format("'{}' has no extension of an image; expected one of {}", name,
                               readable_extensions));
  const auto format = format_of(name, bytes);
  if (!format) return failure(fmt::format("'{}' does not begin as any image that is read", name));
  try {
    if (*format == ImageFormat::Tga) return named(name, decode_tga_file(bytes));
    Result<Bytes> guarded = guard_image(*format, std::move(bytes));
    if (!guarded) return named(name, guarded.diagnostics);
    return named(name, decode_other(*format, std::move(*guarded)));
  } catch (const std::bad_alloc&) {
    return failure(fmt::format("'{}' needs more memory than there is", name));
  } catch (const std::exception& exception) {
    return failure(fmt::format("'{}' cannot be decoded: {}", name, exception.what()));
  }
}

Result<ImageHeader> other_header(ImageFormat format, Bytes bytes, const DecodeLimits& limits) {
  auto plain = format == ImageFormat::Jpeg ? plain_jpeg_header(bytes) : std::nullopt;
  if (plain) {
    plain->channels.resize(std::min(plain->channels.size(), limits.max_channels));
    return within(limits, std::move(*plain));
  }
  const FloatingPointTraps traps(Traps::Off);
  Result<OpenImage> image = open_image(format, std::move(bytes), limits);
  if (!image) return image.diagnostics;
  return header_of(*image, limits);
}

Result<DecodedImage> decode_other(ImageFormat format, Bytes bytes, const DecodeLimits& limits) {
  const FloatingPointTraps traps(Traps::Off);
  Result<OpenImage> image = open_image(format, std::move(bytes), limits);
  if (!image) return image.diagnostics;
  return decode_open_image(*image, limits);
}

std::size_t file_limit(const DecodeLimits& limits) {
  constexpr std::size_t room_for_headers = std::size_t{64} << 20;
  return limits.max_bytes + room_for_headers;
}

}  // namespace

std::unique_ptr<std::byte[]> allocate_samples(const ImageHeader& header) {
  const std::size_t bytes = header.sample_count() * size_of(header.sample_type);
  auto samples = std::make_unique_for_overwrite<std::byte[]>(bytes + sizeof(float));
  advise_large_pages(samples.get(), bytes);
  std::memset(samples.get() + bytes, 0, sizeof(float));
  return samples;
}

Result<ImageHeader> decode_header(const std::string& name, Bytes bytes,
                                  const DecodeLimits& limits) {
  return dispatch<ImageHeader>(
      name, std::move(bytes), [&](const Bytes& tga) { return checked_tga_header(tga, limits); },
      [&](ImageFormat format, Bytes other) {
        return other_header(format, std::move(other), limits);
      });
}

Result<DecodedImage> decode_image(const std::string& name, Bytes bytes,
                                  const DecodeLimits& limits) {
  return dispatch<DecodedImage>(
      name, std::move(bytes), [&](const Bytes& tga) { return checked_tga(tga, limits); },
      [&](ImageFormat format, Bytes other) {
        return decode_other(format, std::move(other), limits);
      });
}

Result<ImageHeader> read_image_header(const std::string& path, const DecodeLimits& limits) {
  Result<Bytes> bytes = read_regular_file(path, file_limit(limits));
  if (!bytes) return bytes.diagnostics;
  return decode_header(path, std::move(*bytes), limits);
}

Result<DecodedImage> read_decoded_image(const std::string& path, const DecodeLimits& limits) {
  Result<Bytes> bytes = read_regular_file(path, file_limit(limits));
  if (!bytes) return bytes.diagnostics;
  return decode_image(path, std::move(*bytes), limits);
}

}  // namespace candela
