// The marker segments of a JPEG file [JPEG92, annex B]: markers FF xx, most with a length and data;
// after the start of a scan comes entropy-coded data.
#pragma once

#include <cstddef>
#include <span>

namespace candela::jpeg {

constexpr unsigned start_of_scan = 0xDA;
constexpr unsigned end_of_image = 0xD9;

struct Segment {
  unsigned marker = 0;
  std::span<const unsigned char> data;  // without marker and length
  std::size_t begin = 0;
  std::size_t end = 0;  // 0: the file ends within the segment
};

// The first segment from `from` on. Bytes between segments are passed over, as libjpeg does.
[[nodiscard]] Segment next_segment(std::span<const unsigned char> bytes, std::size_t from);

// SOF0 ... SOF15 without DHT, JPG and DAC.
[[nodiscard]] bool is_frame(unsigned marker);

// Its header: precision, height, width and the components.
struct Frame {
  bool is_whole = false;
  unsigned bits = 0;
  std::size_t height = 0;
  std::size_t width = 0;
  unsigned components = 0;
};
[[nodiscard]] Frame frame_of(const Segment& segment);

}  // namespace candela::jpeg
