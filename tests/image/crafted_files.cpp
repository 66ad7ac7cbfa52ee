#include "tests/image/crafted_files.h"

#include <zlib.h>

#include <stdexcept>

namespace candela::crafted {
namespace {

Bytes big_endian(std::uint64_t value, int count) {
  Bytes bytes;
  for (int i = count - 1; i >= 0; --i)
    bytes.push_back(static_cast<unsigned char>((value >> (8 * i)) & 255));
  return bytes;
}

Bytes little_endian(std::uint64_t value, int count) {
  Bytes bytes;
  for (int i = 0; i < count; ++i)
    bytes.push_back(static_cast<unsigned char>((value >> (8 * i)) & 255));
  return bytes;
}

unsigned samples_of(PngColour colour) {
  switch (colour) {
    case Grey:
    case Palette:
      return 1;
    case GreyAlpha:
      return 2;
    case Rgb:
      return 3;
    case Rgba:
      return 4;
  }
  return 0;
}

Bytes compressed(const Bytes& raw) {
  uLongf size = compressBound(static_cast<uLong>(raw.size()));
  Bytes bytes(size);
  if (compress(bytes.data(), &size, raw.data(), static_cast<uLong>(raw.size())) != Z_OK)
    throw std::runtime_error("compress");
  bytes.resize(size);
  return bytes;
}

// Each row begins with the number of its filter: 0, none.
Bytes with_filter_bytes(const Png& image) {
  const std::size_t row_bytes =
      (std::size_t{image.width} * image.bit_depth * samples_of(image.colour) + 7) / 8;
  Bytes raw;
  for (std::size_t begin = 0; begin + row_bytes <= image.samples.size(); begin += row_bytes) {
    raw.push_back(0);
    raw.insert(raw.end(), image.samples.begin() + static_cast<std::ptrdiff_t>(begin),
               image.samples.begin() + static_cast<std::ptrdiff_t>(begin + row_bytes));
  }
  return raw;
}

Bytes exr_attribute(const std::string& name, const std::string& type, const Bytes& value) {
  return text(name) + Bytes{0} + text(type) + Bytes{0} + little_endian(value.size(), 4) + value;
}

Bytes box(std::int32_t width, std::int32_t height) {
  return Bytes(8, 0) + little_endian(static_cast<std::uint32_t>(width - 1), 4) +
         little_endian(static_cast<std::uint32_t>(height - 1), 4);
}

Bytes tiff_entry(unsigned tag, unsigned type, std::uint32_t value) {
  return little_endian(tag, 2) + little_endian(type, 2) + little_endian(1, 4) +
         little_endian(value, 4);
}

}  // namespace

Bytes text(const std::string& characters) {
  return {characters.begin(), characters.end()};
}

Bytes operator+(Bytes first, const Bytes& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Bytes png_chunk(const std::string& type, const Bytes& data) {
  const Bytes checked = text(type) + data;
  return big_endian(data.size(), 4) + checked +
         big_endian(crc32_z(0, checked.data(), checked.size()), 4);
}

Bytes png(const Png& image, const Bytes& extra) {
  const Bytes header = big_endian(image.width, 4) + big_endian(image.height, 4) +
                       Bytes{static_cast<unsigned char>(image.bit_depth), image.colour, 0, 0, 0};
  Bytes bytes = text("\x89PNG\r\n\x1a\n") + png_chunk("IHDR", header);
  if (!image.palette.empty()) bytes = bytes + png_chunk("PLTE", image.palette);
  if (!image.transparency.empty()) bytes = bytes + png_chunk("tRNS", image.transparency);
  return bytes + extra + png_chunk("IDAT", compressed(with_filter_bytes(image))) +
         png_chunk("IEND", {});
}

Bytes png_of(int width, int height, PngColour colour, unsigned bit_depth, const Samples& value) {
  Png image;
  image.width = static_cast<std::uint32_t>(width);
  image.height = static_cast<std::uint32_t>(height);
  image.bit_depth = bit_depth;
  image.colour = colour;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (unsigned c = 0; c < samples_of(colour); ++c)
        image.samples = std::move(image.samples) + big_endian(value(x, y, static_cast<int>(c)),
                                                              static_cast<int>(bit_depth / 8));
  return png(image);
}

Bytes png_rgba(int width, int height, const Samples& value) {
  return png_of(width, height, Rgba, 8, value);
}

Bytes tga(const Tga& image) {
  const auto byte = [](unsigned value) { return static_cast<unsigned char>(value); };
  return Bytes{0, byte(image.palette_count > 0 ? 1 : 0), byte(image.type)} + Bytes(2, 0) +
         little_endian(image.palette_count, 2) + Bytes{byte(image.palette_bits)} + Bytes(4, 0) +
         little_endian(image.width, 2) + little_endian(image.height, 2) +
         Bytes{byte(image.bits), byte(image.descriptor)} + image.data;
}

Bytes bmp(const Bmp& image) {
  return text("BM") + little_endian(54 + image.data.size(), 4) + Bytes(4, 0) +
         little_endian(54, 4) + little_endian(40, 4) +
         little_endian(static_cast<std::uint32_t>(image.width), 4) +
         little_endian(static_cast<std::uint32_t>(image.height), 4) + little_endian(1, 2) +
         little_endian(image.bits, 2) + little_endian(image.compression, 4) + Bytes(20, 0) +
         image.data;
}

Bytes exr_claiming(std::int32_t width, std::int32_t height, bool is_tiled,
                   std::uint32_t tile_side) {
  const Bytes channel = text("R") + Bytes{0} + little_endian(2, 4) + Bytes(4, 0) +
                        little_endian(1, 4) + little_endian(1, 4);
  Bytes bytes = text("\x76\x2f\x31\x01") + little_endian(2 | (is_tiled ? 0x200 : 0), 4) +
                exr_attribute("channels", "chlist", channel + Bytes{0}) +
                exr_attribute("compression", "compression", {0}) +
                exr_attribute("dataWindow", "box2i", box(width, height)) +
                exr_attribute("displayWindow", "box2i", box(width, height)) +
                exr_attribute("lineOrder", "lineOrder", {0}) +
                exr_attribute("pixelAspectRatio", "float", little_endian(0x3F800000, 4)) +
                exr_attribute("screenWindowCenter", "v2f", Bytes(8, 0)) +
                exr_attribute("screenWindowWidth", "float", little_endian(0x3F800000, 4));
  if (is_tiled)
    bytes =
        bytes + exr_attribute("tiles", "tiledesc",
                              little_endian(tile_side, 4) + little_endian(tile_side, 4) + Bytes{0});
  return bytes + Bytes(64, 0);
}

Bytes tiff_claiming(std::uint32_t width, std::uint32_t height) {
  constexpr unsigned short_type = 3, long_type = 4;
  const Bytes entries = tiff_entry(256, long_type, width) + tiff_entry(257, long_type, height) +
                        tiff_entry(258, short_type, 8) + tiff_entry(259, short_type, 1) +
                        tiff_entry(262, short_type, 1) + tiff_entry(273, long_type, 8) +
                        tiff_entry(277, short_type, 1) + tiff_entry(278, long_type, height) +
                        tiff_entry(279, long_type, 64);
  return text("II*") + Bytes{0} + little_endian(8, 4) + little_endian(entries.size() / 12, 2) +
         entries + Bytes(68, 0);
}

Bytes with_right_checksums(const Bytes& png) {
  Bytes repaired(png.begin(), png.begin() + std::min<std::ptrdiff_t>(8, std::ssize(png)));
  for (std::size_t at = 8; at + 12 <= png.size();) {
    const std::size_t length = (std::size_t{png[at]} << 24) | (std::size_t{png[at + 1]} << 16) |
                               (std::size_t{png[at + 2]} << 8) | png[at + 3];
    if (length > png.size() - at - 12) break;
    const auto data = png.begin() + static_cast<std::ptrdiff_t>(at);
    repaired =
        std::move(repaired) + png_chunk(std::string(data + 4, data + 8),
                                        Bytes(data + 8, data + 8 + static_cast<long>(length)));
    at += length + 12;
  }
  return repaired;
}

Bytes jpeg_claiming(unsigned width, unsigned height) {
  Bytes bytes = cmyk_jpeg();
  for (std::size_t i = 0; i + 8 < bytes.size(); ++i) {
    if (bytes[i] != 0xFF || bytes[i + 1] != 0xC0) continue;
    const Bytes size = big_endian(height, 2) + big_endian(width, 2);
    std::copy(size.begin(), size.end(), bytes.begin() + static_cast<std::ptrdiff_t>(i + 5));
  }
  return bytes;
}

Bytes cmyk_jpeg() {
  return {0xff, 0xd8, 0xff, 0xee, 0x00, 0x0e, 0x41, 0x64, 0x6f, 0x62, 0x65, 0x00, 0x64, 0x00, 0x00,
          0x00, 0x00, 0x00, 0xff, 0xdb, 0x00, 0x43, 0x00, 0x08, 0x06, 0x06, 0x07, 0x06, 0x05, 0x08,
          0x07, 0x07, 0x07, 0x09, 0x09, 0x08, 0x0a, 0x0c, 0x14, 0x0d, 0x0c, 0x0b, 0x0b, 0x0c, 0x19,
          0x12, 0x13, 0x0f, 0x14, 0x1d, 0x1a, 0x1f, 0x1e, 0x1d, 0x1a, 0x1c, 0x1c, 0x20, 0x24, 0x2e,
          0x27, 0x20, 0x22, 0x2c, 0x23, 0x1c, 0x1c, 0x28, 0x37, 0x29, 0x2c, 0x30, 0x31, 0x34, 0x34,
          0x34, 0x1f, 0x27, 0x39, 0x3d, 0x38, 0x32, 0x3c, 0x2e, 0x33, 0x34, 0x32, 0xff, 0xc0, 0x00,
          0x14, 0x08, 0x00, 0x08, 0x00, 0x08, 0x04, 0x43, 0x11, 0x00, 0x4d, 0x11, 0x00, 0x59, 0x11,
          0x00, 0x4b, 0x11, 0x00, 0xff, 0xc4, 0x00, 0x16, 0x00, 0x01, 0x01, 0x01, 0x00, 0x00, 0x00,
          0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x07, 0x01, 0x06, 0xff, 0xc4,
          0x00, 0x14, 0x10, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
          0x00, 0x00, 0x00, 0x00, 0x00, 0xff, 0xda, 0x00, 0x0e, 0x04, 0x43, 0x00, 0x4d, 0x00, 0x59,
          0x00, 0x4b, 0x00, 0x00, 0x3f, 0x00, 0xdf, 0xa0, 0xfc, 0xca, 0xff, 0xd9};
}

}  // namespace candela::crafted
