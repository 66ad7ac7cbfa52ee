#include "renderer/image/formats/encode_png.h"

#include <png.h>
#include <zlib.h>

#include <array>
#include <bit>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

namespace candela {
namespace {

// What libpng writes to and tells. Functions that it calls leave by longjmp, past no destructor.
struct Session {
  std::string bytes;
  char complaint[160] = "";
  bool lacks_memory = false;
};

[[noreturn]] void fail(png_structp png, png_const_charp message) {
  auto& session = *static_cast<Session*>(png_get_error_ptr(png));
  std::strncpy(session.complaint, message, sizeof(session.complaint) - 1);
  png_longjmp(png, 1);
}

void ignore(png_structp, png_const_charp) {}

png_voidp allocate(png_structp png, png_alloc_size_t bytes) {
  png_voidp memory = std::malloc(bytes);
  if (memory == nullptr) static_cast<Session*>(png_get_mem_ptr(png))->lacks_memory = true;
  return memory;
}
void release(png_structp, png_voidp memory) {
  std::free(memory);
}

bool append(Session& session, const char* more, std::size_t size) {
  try {
    session.bytes.append(more, size);
  } catch (const std::bad_alloc&) {
    session.lacks_memory = true;
  }
  return !session.lacks_memory;
}

void put(png_structp png, png_bytep data, std::size_t size) {
  auto& session = *static_cast<Session*>(png_get_io_ptr(png));
  if (!append(session, reinterpret_cast<const char*>(data), size)) png_error(png, "");
}

const std::string* text_of(const Encodable& image, const std::string& name) {
  for (const EncodableAttribute& attribute : image.attributes)
    if (attribute.first == name) return std::get_if<std::string>(&attribute.second);
  return nullptr;
}

// What a picture tells of itself, ready before libpng is asked.
struct Facts {
  int colour_type = PNG_COLOR_TYPE_GRAY;
  int bits = 8;
  bool is_srgb = false;
  bool has_time = false;
  png_time time{};
};

// "2000:01:31 23:59:59".
bool read_time(const std::string& text, png_time& time) {
  std::array<unsigned, 6> n{};
  if (std::sscanf(text.c_str(), "%4u:%2u:%2u %2u:%2u:%2u", &n[0], &n[1], &n[2], &n[3], &n[4],
                  &n[5]) != 6)
    return false;
  const auto byte = [&](std::size_t i) { return static_cast<png_byte>(n[i]); };
  time = {static_cast<png_uint_16>(n[0]), byte(1), byte(2), byte(3), byte(4), byte(5)};
  return true;
}

Facts facts_of(const Encodable& image) {
  constexpr std::array<int, 4> colour_types{PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA,
                                            PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGB_ALPHA};
  Facts facts;
  facts.colour_type = colour_types[image.header.channels.size() - 1];
  if (image.header.sample_type == SampleType::U16) facts.bits = 16;
  const std::string* const space = text_of(image, "oiio:ColorSpace");
  facts.is_srgb = space != nullptr && *space == "sRGB";
  const std::string* const time = text_of(image, "DateTime");
  facts.has_time = time != nullptr && read_time(*time, facts.time);
  return facts;
}

class PngWriter {
 public:
  PngWriter()
      : png_(png_create_write_struct_2(PNG_LIBPNG_VER_STRING, &session_, fail, ignore, &session_,
                                       allocate, release)),
        info_(png_ != nullptr ? png_create_info_struct(png_) : nullptr) {}
  ~PngWriter() { png_destroy_write_struct(&png_, &info_); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  [[nodiscard]] bool write(const Encodable& image, const Facts& facts) {
    if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_write_fn(png_, &session_, put, nullptr);
    png_set_IHDR(png_, info_, static_cast<png_uint_32>(image.header.width),
                 static_cast<png_uint_32>(image.header.height), facts.bits, facts.colour_type,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_BASE, PNG_FILTER_TYPE_BASE);
    // Noise repeats nothing but runs: to look for more takes two to six times as long for 2 % of
    // the size at most (docs/decisions.md).
    png_set_compression_strategy(png_, Z_RLE);
    if (facts.is_srgb) png_set_sRGB_gAMA_and_cHRM(png_, info_, PNG_sRGB_INTENT_ABSOLUTE);
    if (facts.has_time) png_set_tIME(png_, info_, &facts.time);
    png_write_info(png_, info_);
    if (facts.bits == 16 && std::endian::native == std::endian::little) png_set_swap(png_);
    write_rows(image);
    png_write_end(png_, info_);
    return true;
  }

  [[nodiscard]] std::string take() { return std::move(session_.bytes); }
  [[nodiscard]] const char* complaint() const { return session_.complaint; }
  [[nodiscard]] bool lacks_memory() const { return session_.lacks_memory; }

 private:
  void write_rows(const Encodable& image) {
    const std::size_t row_bytes = static_cast<std::size_t>(image.header.width) *
                                  image.header.channels.size() * size_of(image.header.sample_type);
    const auto* row = reinterpret_cast<png_const_bytep>(image.samples);
    for (int y = 0; y < image.header.height; ++y, row += row_bytes) png_write_row(png_, row);
  }

  Session session_;
  png_structp png_;
  png_infop info_;
};

}  // namespace

Result<std::string> encode_png(const Encodable& image) {
  if (image.header.channels.size() > 4) return failure("it holds at most four channels");
  PngWriter writer;
  if (!writer.write(image, facts_of(image))) {
    if (writer.lacks_memory()) throw std::bad_alloc();
    return failure(writer.complaint());
  }
  return writer.take();
}

}  // namespace candela
