#include "renderer/image/formats/jpeg_segments.h"

#include "renderer/image/formats/byte_cursor.h"

namespace candela::jpeg {
namespace {

// TEM, RSTn and SOI stand alone.
bool has_length(unsigned marker) {
  return marker != 0x01 && !(marker >= 0xD0 && marker <= 0xD8);
}

}  // namespace

bool is_frame(unsigned marker) {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

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

Frame frame_of(const Segment& segment) {
  ByteCursor cursor(segment.data);
  Frame frame;
  frame.bits = cursor.u8();
  frame.height = cursor.u16_big();
  frame.width = cursor.u16_big();
  frame.components = cursor.u8();
  frame.is_whole = cursor.is_good() && frame.width > 0 && frame.height > 0;
  return frame;
}

}  // namespace candela::jpeg
