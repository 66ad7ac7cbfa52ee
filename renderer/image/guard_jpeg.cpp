// [JPEG92, annex B]: markers FF xx, most with a length and data; after SOS comes entropy-coded
// data.
#include <algorithm>

#include <fmt/format.h>

#include "renderer/image/byte_cursor.h"
#include "renderer/image/guard.h"

namespace candela {
namespace {

constexpr unsigned start_of_scan = 0xDA;
constexpr unsigned end_of_image = 0xD9;

// SOF0 ... SOF15 without DHT, JPG and DAC.
bool is_frame(unsigned marker) {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

bool is_arithmetic(unsigned marker) {
  return is_frame(marker) && marker > 0xC8;
}

// APP0 (JFIF) and APP14 (Adobe) say how colours are stored; the other APPn and comments do not.
bool is_metadata(unsigned marker) {
  const bool is_app = marker >= 0xE0 && marker <= 0xEF;
  return marker == 0xFE || (is_app && marker != 0xE0 && marker != 0xEE);
}

// TEM, RSTn and SOI stand alone.
bool has_length(unsigned marker) {
  return marker != 0x01 && !(marker >= 0xD0 && marker <= 0xD8);
}

// A Huffman code has at least one bit, and each block of 8x8 at least one code.
Diagnostics check_frame(unsigned marker, std::span<const unsigned char> data, std::size_t bytes) {
  ByteCursor cursor(data);
  cursor.skip(1);
  const std::uint64_t height = cursor.u16_big();
  const std::uint64_t width = cursor.u16_big();
  if (!cursor.is_good() || width == 0 || height == 0) return failure("has a broken JPEG header");
  const std::uint64_t blocks = ((width + 7) / 8) * ((height + 7) / 8);
  if (is_arithmetic(marker) || blocks <= std::uint64_t{bytes} * 8) return {};
  return failure(fmt::format("claims {} x {} pixels, which its {} bytes of data cannot hold", width,
                             height, bytes));
}

struct Segment {
  unsigned marker = 0;
  std::span<const unsigned char> data;  // without marker and length
  std::size_t begin = 0, end = 0;
};

// Bytes between segments are passed over, as libjpeg does.
Segment next_segment(std::span<const unsigned char> bytes, std::size_t from) {
  while (from < bytes.size() && bytes[from] != 0xFF) ++from;
  while (from + 1 < bytes.size() && (bytes[from + 1] == 0xFF || bytes[from + 1] == 0)) ++from;
  ByteCursor cursor(bytes, from + 1);
  Segment segment;
  segment.begin = from;
  segment.marker = cursor.u8();
  if (has_length(segment.marker) && segment.marker != end_of_image) {
    const std::size_t length = cursor.u16_big();
    segment.data = cursor.take(length < 2 ? bytes.size() : length - 2);
  }
  segment.end = cursor.is_good() ? cursor.position() : 0;
  return segment;
}

}  // namespace

Result<Bytes> guard_jpeg(Bytes bytes) {
  std::size_t to = 0;
  bool has_frame = false;
  const auto keep = [&](std::size_t begin, std::size_t end) {
    std::copy(bytes.begin() + static_cast<std::ptrdiff_t>(begin),
              bytes.begin() + static_cast<std::ptrdiff_t>(end),
              bytes.begin() + static_cast<std::ptrdiff_t>(to));
    to += end - begin;
  };
  for (std::size_t from = 0;;) {
    const Segment segment = next_segment(bytes, from);
    if (segment.end == 0 || segment.marker == end_of_image)
      return failure("is truncated: it ends within a JPEG's header");
    if (segment.marker == start_of_scan) {
      if (!has_frame) return failure("has a broken JPEG header");
      keep(segment.begin, bytes.size());
      break;
    }
    if (is_frame(segment.marker)) {
      has_frame = true;
      Diagnostics found = check_frame(segment.marker, segment.data, bytes.size());
      if (found.has_errors()) return found;
    }
    if (!is_metadata(segment.marker)) keep(segment.begin, segment.end);
    from = segment.end;
  }
  bytes.resize(to);
  return bytes;
}

}  // namespace candela
