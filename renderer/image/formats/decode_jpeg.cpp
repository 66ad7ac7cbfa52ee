#include "renderer/image/formats/decode_jpeg.h"

#include <csetjmp>
#include <cstdio>  // which jpeglib.h needs

#include <jpeglib.h>

#include <jerror.h>

#include <new>
#include <utility>

#include "renderer/image/formats/damage.h"
#include "renderer/image/formats/jpeg_segments.h"

namespace candela {
namespace {

// SOF0, SOF1, SOF2: baseline, extended sequential, progressive.
bool is_huffman_coded(unsigned marker) {
  return marker >= 0xC0 && marker <= 0xC2;
}

// What libjpeg tells. Functions that it calls leave by longjmp, past no destructor.
struct Session {
  jpeg_error_mgr manager{};  // first, so that libjpeg's pointer to it is one to the whole
  std::jmp_buf jump{};
  char complaint[JMSG_LENGTH_MAX] = "";  // the first one
  bool ends_too_early = false;
};

Session& session_of(j_common_ptr jpeg) {
  return *reinterpret_cast<Session*>(jpeg->err);
}

[[noreturn]] void fail(j_common_ptr jpeg) {
  Session& session = session_of(jpeg);
  session.manager.format_message(jpeg, session.complaint);
  std::longjmp(session.jump, 1);
}

// Levels below 0 are warnings of damaged data, which libjpeg fills in; it puts grey where a file
// ends too early.
void warn(j_common_ptr jpeg, int level) {
  Session& session = session_of(jpeg);
  if (level >= 0) return;
  if (session.manager.msg_code == JWRN_JPEG_EOF) session.ends_too_early = true;
  if (session.complaint[0] == 0) session.manager.format_message(jpeg, session.complaint);
}

class JpegReader {
 public:
  JpegReader() {
    jpeg_.err = jpeg_std_error(&session_.manager);
    session_.manager.error_exit = fail;
    session_.manager.emit_message = warn;
  }
  ~JpegReader() { jpeg_destroy_decompress(&jpeg_); }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;

  // Of a file of this size and these channels. False where the file is at fault, or memory lacks.
  [[nodiscard]] bool read(const Bytes& bytes, const ImageHeader& header, std::byte* out) {
    if (setjmp(session_.jump) != 0) return false;
    jpeg_create_decompress(&jpeg_);
    jpeg_mem_src(&jpeg_, bytes.data(), bytes.size());
    jpeg_read_header(&jpeg_, TRUE);
    jpeg_start_decompress(&jpeg_);
    if (!is_as_told(header)) ERREXIT(&jpeg_, JERR_BAD_LENGTH);
    const std::size_t row_bytes = std::size_t{jpeg_.output_width} * header.channels.size();
    while (jpeg_.output_scanline < jpeg_.output_height) {
      JSAMPROW row = reinterpret_cast<JSAMPROW>(out) + jpeg_.output_scanline * row_bytes;
      jpeg_read_scanlines(&jpeg_, &row, 1);
    }
    return !session_.ends_too_early;
  }

  [[nodiscard]] const char* complaint() const { return session_.complaint; }
  [[nodiscard]] bool lacks_memory() const {
    return session_.manager.msg_code == JERR_OUT_OF_MEMORY;
  }

 private:
  [[nodiscard]] bool is_as_told(const ImageHeader& header) const {
    return std::cmp_equal(jpeg_.output_width, header.width) &&
           std::cmp_equal(jpeg_.output_height, header.height) &&
           std::cmp_equal(jpeg_.output_components, header.channels.size());
  }

  Session session_;
  jpeg_decompress_struct jpeg_{};
};

}  // namespace

Result<DecodedImage> decode_plain_jpeg(const Bytes& bytes, const ImageHeader& header) {
  JpegReader reader;
  DecodedImage decoded;
  decoded.header = header;
  decoded.samples = allocate_samples(header);
  if (!reader.read(bytes, header, decoded.samples.get())) {
    if (reader.lacks_memory()) throw std::bad_alloc();
    return is_damaged(reader.complaint());
  }
  return {std::move(decoded), is_damaged_but_readable(reader.complaint())};
}

std::optional<ImageHeader> plain_jpeg_header(const Bytes& bytes) {
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
