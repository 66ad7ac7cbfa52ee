#include "renderer/image/formats/decode_tga.h"

#include <algorithm>
#include <array>
#include <cstring>

#include <fmt/format.h>

#include "renderer/image/formats/byte_cursor.h"

namespace candela {
namespace {

constexpr std::size_t header_size = 18;

enum class Kind : std::uint8_t { Palette = 1, Colour = 2, Grey = 3 };

struct TgaHeader {
  std::size_t id_bytes = 0;
  Kind kind = Kind::Colour;
  bool is_run_length_encoded = false;
  std::size_t palette_first = 0, palette_count = 0;
  unsigned palette_bits = 0;
  int width = 0, height = 0;
  unsigned bits = 0;
  bool is_top_first = false, is_right_first = false;
};

std::size_t bytes_of(unsigned bits) {
  return (bits + 7) / 8;
}

bool is_colour_depth(unsigned bits) {
  return bits == 15 || bits == 16 || bits == 24 || bits == 32;
}

bool is_supported(const TgaHeader& header) {
  switch (header.kind) {
    case Kind::Palette:
      return (header.bits == 8 || header.bits == 16) && is_colour_depth(header.palette_bits);
    case Kind::Colour:
      return is_colour_depth(header.bits);
    case Kind::Grey:
      return header.bits == 8 || header.bits == 16;
  }
  return false;
}

Result<TgaHeader> read_header(const Bytes& bytes) {
  ByteCursor cursor(bytes);
  TgaHeader header;
  header.id_bytes = cursor.u8();
  const unsigned palette_type = cursor.u8();
  const unsigned type = cursor.u8();
  header.palette_first = cursor.u16_little();
  header.palette_count = cursor.u16_little();
  header.palette_bits = cursor.u8();
  cursor.skip(4);
  header.width = cursor.u16_little();
  header.height = cursor.u16_little();
  header.bits = cursor.u8();
  const unsigned descriptor = cursor.u8();
  if (!cursor.is_good()) return failure("is truncated: it ends within a TGA's header");
  header.is_run_length_encoded = (type & 8) != 0;
  header.kind = static_cast<Kind>(type & 3);
  header.is_right_first = (descriptor & 0x10) != 0;
  header.is_top_first = (descriptor & 0x20) != 0;
  const bool is_known = (type & ~8u) >= 1 && (type & ~8u) <= 3 && palette_type <= 1;
  if (!is_known || !is_supported(header)) return failure("is no TGA of a kind that is read");
  if (palette_type == 0) header.palette_count = 0;
  if (header.width == 0 || header.height == 0) return failure("claims a TGA without pixels");
  return header;
}

std::size_t channels_of(const TgaHeader& header) {
  if (header.kind == Kind::Grey) return header.bits == 16 ? 2 : 1;
  const unsigned bits = header.kind == Kind::Palette ? header.palette_bits : header.bits;
  return bits == 32 ? 4 : 3;
}

// Stored blue first; 15 and 16 bits as arrrrrgg gggbbbbb, whose top bit is seldom meant.
std::array<unsigned char, 4> colour_of(std::span<const unsigned char> in) {
  if (in.size() >= 3)
    return {in[2], in[1], in[0], in.size() == 4 ? in[3] : static_cast<unsigned char>(255)};
  const unsigned packed = in[0] | (static_cast<unsigned>(in[1]) << 8);
  const auto widened = [&](unsigned shift) {
    return static_cast<unsigned char>((((packed >> shift) & 31) * 255 + 15) / 31);
  };
  return {widened(10), widened(5), widened(0), 255};
}

class Decoder {
 public:
  Decoder(const Bytes& bytes, const TgaHeader& header, std::byte* out)
      : header_(header),
        channels_(channels_of(header)),
        cursor_(bytes, header_size + header.id_bytes),
        out_(out) {
    palette_ = cursor_.take(header.palette_count * bytes_of(header.palette_bits));
  }

  bool run() {
    const std::size_t count =
        static_cast<std::size_t>(header_.width) * static_cast<std::size_t>(header_.height);
    for (std::size_t i = 0; i < count;) {
      const unsigned packet = header_.is_run_length_encoded ? cursor_.u8() : 0x7F;
      const std::size_t length = std::min<std::size_t>((packet & 0x7F) + 1, count - i);
      if (!put_packet(i, length, header_.is_run_length_encoded && (packet & 0x80) != 0))
        return false;
      i += length;
    }
    return true;
  }

 private:
  // `length` pixels from the `first` in the file's order: one stored and repeated, or all stored.
  bool put_packet(std::size_t first, std::size_t length, bool is_repeated) {
    std::span<const unsigned char> stored;
    for (std::size_t k = 0; k < length; ++k) {
      if (k == 0 || !is_repeated) stored = cursor_.take(bytes_of(header_.bits));
      if (!cursor_.is_good() || !put_pixel(first + k, stored)) return false;
    }
    return true;
  }

  bool put_pixel(std::size_t index, std::span<const unsigned char> stored) {
    std::byte* out = out_ + place_of(index) * channels_;
    if (header_.kind == Kind::Grey) {
      std::memcpy(out, stored.data(), channels_);
      return true;
    }
    if (header_.kind == Kind::Palette) stored = palette_entry(stored);
    if (stored.empty()) return false;
    const auto colour = colour_of(stored);
    std::memcpy(out, colour.data(), channels_);
    return true;
  }

  [[nodiscard]] std::span<const unsigned char> palette_entry(
      std::span<const unsigned char> stored) const {
    const std::size_t index =
        stored[0] | (stored.size() > 1 ? static_cast<std::size_t>(stored[1]) << 8 : 0);
    if (index < header_.palette_first) return {};
    const std::size_t size = bytes_of(header_.palette_bits);
    const std::size_t begin = (index - header_.palette_first) * size;
    return begin + size <= palette_.size() ? palette_.subspan(begin, size)
                                           : std::span<const unsigned char>{};
  }

  // Rows come from the bottom and pixels from the left unless the header says otherwise.
  [[nodiscard]] std::size_t place_of(std::size_t index) const {
    const auto width = static_cast<std::size_t>(header_.width);
    const auto height = static_cast<std::size_t>(header_.height);
    const std::size_t row = index / width;
    const std::size_t column = index % width;
    return (header_.is_top_first ? row : height - 1 - row) * width +
           (header_.is_right_first ? width - 1 - column : column);
  }

  const TgaHeader& header_;
  std::size_t channels_;
  ByteCursor cursor_;
  std::byte* out_;
  std::span<const unsigned char> palette_;
};

ImageHeader image_header(const TgaHeader& tga) {
  ImageHeader header;
  header.width = tga.width;
  header.height = tga.height;
  switch (channels_of(tga)) {
    case 1:
      header.channels = {"Y"};
      break;
    case 2:
      header.channels = {"Y", "A"};
      break;
    case 3:
      header.channels = {"R", "G", "B"};
      break;
    default:
      header.channels = {"R", "G", "B", "A"};
  }
  const bool has_alpha = header.channels.size() % 2 == 0;
  header.alpha_channel = has_alpha ? static_cast<int>(header.channels.size()) - 1 : -1;
  header.alpha_is_straight = true;
  return header;
}

// A packet of at most five bytes makes 128 pixels.
bool can_hold(const Bytes& bytes, const TgaHeader& header) {
  const auto pixels =
      static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height);
  const std::size_t stored = bytes_of(header.bits);
  const std::size_t least =
      header.is_run_length_encoded ? pixels / 128 * (stored + 1) : pixels * stored;
  return bytes.size() >= least;
}

}  // namespace

Result<ImageHeader> decode_tga_header(const Bytes& bytes) {
  const Result<TgaHeader> header = read_header(bytes);
  if (!header) return header.diagnostics;
  if (!can_hold(bytes, *header))
    return failure(fmt::format("claims {} x {} pixels, which its {} bytes cannot hold",
                               header->width, header->height, bytes.size()));
  return image_header(*header);
}

Result<DecodedImage> decode_tga(const Bytes& bytes) {
  Result<ImageHeader> checked = decode_tga_header(bytes);
  if (!checked) return checked.diagnostics;
  DecodedImage image;
  image.header = std::move(*checked);
  image.samples = allocate_samples(image.header);
  const Result<TgaHeader> header = read_header(bytes);
  if (!Decoder(bytes, *header, image.samples.get()).run())
    return failure("is truncated or damaged: a pixel of the TGA is missing");
  return image;
}

}  // namespace candela
