// Image files made byte by byte, so that tests own every number in them, the lies included.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace candela::crafted {

using Bytes = std::vector<unsigned char>;

// Colour types of PNG.
enum PngColour : std::uint8_t { Grey = 0, Rgb = 2, Palette = 3, GreyAlpha = 4, Rgba = 6 };

struct Png {
  std::uint32_t width = 1, height = 1;
  unsigned bit_depth = 8;
  PngColour colour = Rgb;
  Bytes samples;       // rows from the top, packed as the format packs them, without filter bytes
  Bytes palette;       // 3 bytes an entry
  Bytes transparency;  // the chunk tRNS
};
// `extra`: chunks put in before the data, made by png_chunk.
[[nodiscard]] Bytes png(const Png& image, const Bytes& extra = {});
[[nodiscard]] Bytes png_chunk(const std::string& type, const Bytes& data);

// A PNG, however damaged, with the checksums that its chunks should have.
[[nodiscard]] Bytes with_right_checksums(const Bytes& png);

// 8-bit RGBA, `value(x, y, channel)`.
using Samples = std::function<unsigned(int x, int y, int channel)>;
[[nodiscard]] Bytes png_rgba(int width, int height, const Samples& value);
[[nodiscard]] Bytes png_of(int width, int height, PngColour colour, unsigned bit_depth,
                           const Samples& value);

struct Tga {
  unsigned type = 2;
  unsigned width = 1, height = 1;
  unsigned bits = 24;
  unsigned descriptor = 0;
  unsigned palette_count = 0, palette_bits = 0;
  Bytes data;  // palette, then pixels
};
[[nodiscard]] Bytes tga(const Tga& image);

struct Bmp {
  std::int32_t width = 1, height = 1;
  unsigned bits = 24;
  std::uint32_t compression = 0;
  Bytes data;
};
[[nodiscard]] Bytes bmp(const Bmp& image);

[[nodiscard]] Bytes text(const std::string& characters);
[[nodiscard]] Bytes operator+(Bytes first, const Bytes& second);

// Headers that claim this size, with hardly any data behind them.
[[nodiscard]] Bytes exr_claiming(std::int32_t width, std::int32_t height, bool is_tiled,
                                 std::uint32_t tile_side = 64);
[[nodiscard]] Bytes tiff_claiming(std::uint32_t width, std::uint32_t height);
[[nodiscard]] Bytes jpeg_claiming(unsigned width, unsigned height);

// 8x8 of one colour: 64, 128, 191 and 26 of 255 parts of cyan, magenta, yellow and black.
[[nodiscard]] Bytes cmyk_jpeg();

}  // namespace candela::crafted
