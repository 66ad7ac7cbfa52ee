#include "renderer/image/jpeg_header.h"

#include "renderer/image/jpeg_segments.h"

namespace candela {
namespace {

// SOF0, SOF1, SOF2: baseline, extended sequential, progressive.
bool is_huffman_coded(unsigned marker) {
  return marker >= 0xC0 && marker <= 0xC2;
}

}  // namespace

std::optional<ImageHeader> plain_jpeg_header(std::span<const unsigned char> bytes) {
  for (std::size_t from = 0;;) {
    const jpeg::Segment segment = jpeg::next_segment(bytes, from);
    from = segment.end;
    if (from == 0 || segment.marker == jpeg::start_of_scan || segment.marker == jpeg::end_of_image)
      return std::nullopt;
    if (!jpeg::is_frame(segment.marker)) continue;
    const jpeg::Frame frame = jpeg::frame_of(segment);
    const bool is_plain = frame.components == 1 || frame.components == 3;
    if (!frame.is_whole || !is_huffman_coded(segment.marker) || frame.bits != 8 || !is_plain)
      return std::nullopt;
    ImageHeader header;
    header.width = static_cast<int>(frame.width);
    header.height = static_cast<int>(frame.height);
    header.channels = frame.components == 1 ? std::vector<std::string>{"Y"}
                                            : std::vector<std::string>{"R", "G", "B"};
    header.alpha_is_straight = true;
    return header;
  }
}

}  // namespace candela
