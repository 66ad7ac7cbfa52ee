// Windows bitmaps: a file header of 14 bytes, an info header that begins with its own size.
#include <algorithm>
#include <array>
#include <cstdlib>

#include <fmt/format.h>

#include "renderer/image/formats/byte_cursor.h"
#include "renderer/image/formats/guard.h"

namespace candela {
namespace {

// The info headers of OS/2 and Windows 3, 4 and 5. OpenImageIO 2.4.7 takes any other size for a
// header and goes on with numbers that were never set.
constexpr std::uint32_t os2_size = 12;
constexpr std::array<std::uint32_t, 4> info_sizes{os2_size, 40, 108, 124};

struct BmpHeader {
  std::uint32_t pixel_offset = 0;
  std::int64_t width = 0, height = 0;
  unsigned bits = 0;
  std::uint32_t compression = 0;
  bool is_good = false;
};

BmpHeader read_header(const Bytes& bytes) {
  BmpHeader header;
  ByteCursor cursor(bytes, 10);
  header.pixel_offset = cursor.u32_little();
  const std::uint32_t info_size = cursor.u32_little();
  const bool is_os2 = info_size == os2_size;
  header.width = is_os2 ? cursor.u16_little() : cursor.i32_little();
  header.height = is_os2 ? cursor.u16_little() : cursor.i32_little();
  cursor.skip(2);
  header.bits = cursor.u16_little();
  if (!is_os2) header.compression = cursor.u32_little();
  const bool is_known = std::ranges::find(info_sizes, info_size) != info_sizes.end();
  header.is_good = cursor.is_good() && is_known && bytes.size() >= 14 + info_size;
  return header;
}

}  // namespace

Result<Bytes> guard_bmp(Bytes bytes) {
  constexpr std::uint32_t plain = 0, bit_fields = 3;
  const BmpHeader header = read_header(bytes);
  const std::int64_t rows = std::abs(header.height);
  if (!header.is_good || header.width <= 0 || rows == 0 || header.bits == 0 || header.bits > 32)
    return failure("has a broken BMP header");
  if (header.compression != plain && header.compression != bit_fields)
    return failure("is a compressed BMP; uncompressed ones are read");
  const double row_bytes = static_cast<double>((header.width * header.bits + 31) / 32 * 4);
  const double needed = header.pixel_offset + row_bytes * static_cast<double>(rows);
  if (needed <= static_cast<double>(bytes.size())) return bytes;
  return failure(fmt::format("claims {} x {} pixels, which its {} bytes cannot hold", header.width,
                             rows, bytes.size()));
}

}  // namespace candela
