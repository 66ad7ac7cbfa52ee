#include "renderer/image/formats/decode_png.h"

#include <png.h>

#include <bit>
#include <csetjmp>
#include <cstring>

#include "renderer/image/formats/damage.h"

namespace candela {
namespace {

// What libpng reads from and tells. Functions that it calls leave by longjmp, past no destructor.
struct Session {
  const unsigned char* next = nullptr;
  std::size_t left = 0;
  char complaint[160] = "";  // the first one
};

void note(Session& session, const char* message) {
  if (session.complaint[0] == 0)
    std::strncpy(session.complaint, message, sizeof(session.complaint) - 1);
}

[[noreturn]] void fail(png_structp png, png_const_charp message) {
  auto& session = *static_cast<Session*>(png_get_error_ptr(png));
  session.complaint[0] = 0;
  note(session, message);
  png_longjmp(png, 1);
}

void warn(png_structp png, png_const_charp message) {
  note(*static_cast<Session*>(png_get_error_ptr(png)), message);
}

void take(png_structp png, png_bytep out, std::size_t size) {
  auto& session = *static_cast<Session*>(png_get_io_ptr(png));
  if (size > session.left) png_error(png, "it ends too early");
  std::memcpy(out, session.next, size);
  session.next += size;
  session.left -= size;
}

class PngReader {
 public:
  explicit PngReader(const Bytes& bytes)
      : session_{bytes.data(), bytes.size()},
        png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &session_, fail, warn)),
        info_(png_ != nullptr ? png_create_info_struct(png_) : nullptr) {}
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  // Reads all before the data.
  [[nodiscard]] bool open() {
    if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_read_fn(png_, &session_, take);
    png_read_info(png_, info_);
    png_set_expand(png_);
    if constexpr (std::endian::native == std::endian::little) png_set_swap(png_);
    passes_ = png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }

  // After open().
  [[nodiscard]] ImageHeader header() const {
    ImageHeader header;
    header.width = static_cast<int>(png_get_image_width(png_, info_));
    header.height = static_cast<int>(png_get_image_height(png_, info_));
    header.sample_type = png_get_bit_depth(png_, info_) == 16 ? SampleType::U16 : SampleType::U8;
    const unsigned channels = png_get_channels(png_, info_);
    header.channels = channels < 3 ? std::vector<std::string>{"Y", "A"}
                                   : std::vector<std::string>{"R", "G", "B", "A"};
    header.channels.resize(channels);
    header.alpha_channel = channels % 2 == 0 ? static_cast<int>(channels) - 1 : -1;
    header.alpha_is_straight = true;
    return header;
  }

  // After open(). An interlaced picture comes in passes, each of which adds to what is there.
  [[nodiscard]] bool read_rows(std::byte* out) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    const std::size_t row_bytes = png_get_rowbytes(png_, info_);
    const std::size_t rows = png_get_image_height(png_, info_);
    for (int pass = 0; pass < passes_; ++pass)
      for (std::size_t y = 0; y < rows; ++y)
        png_read_row(png_, reinterpret_cast<png_bytep>(out) + y * row_bytes, nullptr);
    return true;
  }

  [[nodiscard]] const char* complaint() const { return session_.complaint; }

 private:
  Session session_;
  png_structp png_;
  png_infop info_;
  int passes_ = 1;
};

}  // namespace

Result<ImageHeader> decode_png_header(const Bytes& bytes) {
  PngReader reader(bytes);
  if (!reader.open()) return is_damaged(reader.complaint());
  return reader.header();
}

Result<DecodedImage> decode_png(const Bytes& bytes, const ImageHeader& header) {
  PngReader reader(bytes);
  DecodedImage decoded;
  decoded.header = header;
  decoded.samples = allocate_samples(header);
  if (!reader.open() || !reader.read_rows(decoded.samples.get()))
    return is_damaged(reader.complaint());
  return {std::move(decoded), is_damaged_but_readable(reader.complaint())};
}

}  // namespace candela
