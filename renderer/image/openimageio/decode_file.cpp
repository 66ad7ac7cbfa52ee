#include "renderer/image/openimageio/decode_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>

#include <fmt/format.h>

#include "renderer/base/floating_point_traps.h"
#include "renderer/image/decode_limits.h"
#include "renderer/image/formats/damage.h"
#include "renderer/image/openimageio/sample_type.h"

namespace candela {
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
  return is_passable ? is_damaged_but_readable(first_line(text)) : is_damaged(first_line(text));
}

Result<DecodedImage> decode_open_image(OpenImage& image, const DecodeLimits& limits) {
  DecodedImage decoded;
  decoded.header = header_of(image, limits);
  decoded.samples = allocate_samples(decoded.header);
  const bool is_read = read_rows(image, decoded.header, decoded.samples.get());
  const std::string complaint = image.input->geterror();
  if (!is_read) return is_damaged(first_line(complaint));
  Diagnostics found = complaint_of(image, complaint);
  if (found.has_errors()) return found;
  warn_of_inks(image, found);
  return {std::move(decoded), std::move(found)};
}

}  // namespace

Result<ImageHeader> decode_file_header(ImageFormat format, Bytes bytes,
                                       const DecodeLimits& limits) {
  const FloatingPointTraps traps(Traps::Off);
  Result<OpenImage> image = open_image(format, std::move(bytes), limits);
  if (!image) return image.diagnostics;
  return header_of(*image, limits);
}

Result<DecodedImage> decode_file(ImageFormat format, Bytes bytes, const DecodeLimits& limits) {
  const FloatingPointTraps traps(Traps::Off);
  Result<OpenImage> image = open_image(format, std::move(bytes), limits);
  if (!image) return image.diagnostics;
  return decode_open_image(*image, limits);
}

}  // namespace candela
