#include <algorithm>

#include <fmt/format.h>

#include "renderer/image/formats/guard.h"
#include "renderer/image/formats/jpeg_segments.h"

namespace candela {
namespace {

bool is_arithmetic(unsigned marker) {
  return jpeg::is_frame(marker) && marker > 0xC8;
}

// APP0 (JFIF) and APP14 (Adobe) say how colours are stored; the other APPn and comments do not.
bool is_metadata(unsigned marker) {
  const bool is_app = marker >= 0xE0 && marker <= 0xEF;
  return marker == 0xFE || (is_app && marker != 0xE0 && marker != 0xEE);
}

// A Huffman code has at least one bit, and each block of 8x8 at least one code.
Diagnostics check_frame(const jpeg::Segment& segment, std::size_t bytes) {
  const jpeg::Frame frame = jpeg::frame_of(segment);
  if (!frame.is_whole) return failure("has a broken JPEG header");
  const std::uint64_t blocks = ((frame.width + 7) / 8) * ((frame.height + 7) / 8);
  if (is_arithmetic(segment.marker) || blocks <= std::uint64_t{bytes} * 8) return {};
  return failure(fmt::format("claims {} x {} pixels, which its {} bytes of data cannot hold",
                             frame.width, frame.height, bytes));
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
    const jpeg::Segment segment = jpeg::next_segment(bytes, from);
    if (segment.end == 0 || segment.marker == jpeg::end_of_image)
      return failure("is truncated: it ends within a JPEG's header");
    if (segment.marker == jpeg::start_of_scan) {
      if (!has_frame) return failure("has a broken JPEG header");
      keep(segment.begin, bytes.size());
      break;
    }
    if (jpeg::is_frame(segment.marker)) {
      has_frame = true;
      Diagnostics found = check_frame(segment, bytes.size());
      if (found.has_errors()) return found;
    }
    if (!is_metadata(segment.marker)) keep(segment.begin, segment.end);
    from = segment.end;
  }
  bytes.resize(to);
  return bytes;
}

}  // namespace candela
