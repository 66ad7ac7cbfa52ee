// [PNG03]: a signature, then chunks of length, type, data and the data's CRC.
#include <zlib.h>

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "renderer/image/formats/byte_cursor.h"
#include "renderer/image/formats/guard.h"

namespace candela {
namespace {

constexpr std::size_t signature_size = 8;
constexpr std::size_t chunk_overhead = 12;       // length, type, CRC
constexpr std::uint32_t longest_side = 1000000;  // libpng's own limit
// Deflate gives at most 258 bytes for two bits, its headers aside.
constexpr double best_compression = 1032;

struct Chunk {
  std::string_view type;
  std::span<const unsigned char> data;
  std::span<const unsigned char> whole;
  bool is_complete = false;
  bool is_intact = false;
};

Chunk read_chunk(std::span<const unsigned char> rest) {
  Chunk chunk;
  ByteCursor cursor(rest);
  const std::uint32_t length = cursor.u32_big();
  const auto type = cursor.take(4);
  chunk.data = cursor.take(length);
  const std::uint32_t stored = cursor.u32_big();
  chunk.is_complete = cursor.is_good();
  if (!chunk.is_complete) return chunk;
  chunk.type = {reinterpret_cast<const char*>(type.data()), type.size()};
  chunk.whole = rest.first(chunk_overhead + length);
  chunk.is_intact = ::crc32_z(0, type.data(), type.size() + length) == stored;
  return chunk;
}

bool is_needed(std::string_view type) {
  constexpr std::array<std::string_view, 5> needed{"IHDR", "PLTE", "tRNS", "IDAT", "IEND"};
  return std::ranges::find(needed, type) != needed.end();
}

struct PngHeader {
  std::uint32_t width, height;
  unsigned bit_depth, colour_type;
};

unsigned samples_a_pixel(unsigned colour_type) {
  constexpr std::array<unsigned, 7> counts{1, 0, 3, 1, 2, 0, 4};
  return colour_type < counts.size() ? counts[colour_type] : 0;
}

Diagnostics check_header(std::span<const unsigned char> data, PngHeader& header) {
  ByteCursor cursor(data);
  header = {cursor.u32_big(), cursor.u32_big(), cursor.u8(), cursor.u8()};
  if (data.size() != 13 || header.width == 0 || header.height == 0)
    return failure("has a broken PNG header");
  const unsigned depth = header.bit_depth;
  const bool is_depth_known = depth == 1 || depth == 2 || depth == 4 || depth == 8 || depth == 16;
  if (!is_depth_known || samples_a_pixel(header.colour_type) == 0)
    return failure("has a broken PNG header");
  if (header.width > longest_side || header.height > longest_side)
    return failure(fmt::format("claims {} x {} pixels; a side of at most {} is read", header.width,
                               header.height, longest_side));
  return {};
}

Diagnostics check_amount(const PngHeader& header, std::size_t compressed_bytes) {
  const double bits =
      static_cast<double>(header.width) * header.bit_depth * samples_a_pixel(header.colour_type);
  const double raw_bytes = static_cast<double>(header.height) * (bits / 8 + 1);
  if (raw_bytes <= best_compression * (static_cast<double>(compressed_bytes) + 64)) return {};
  return failure(fmt::format("claims {} x {} pixels, which its {} bytes of data cannot hold",
                             header.width, header.height, compressed_bytes));
}

}  // namespace

Result<Bytes> guard_png(Bytes bytes) {
  std::size_t from = signature_size;
  std::size_t to = signature_size;
  std::size_t compressed_bytes = 0;
  PngHeader header{};
  for (bool is_ended = false; !is_ended;) {
    const Chunk chunk = read_chunk(std::span<const unsigned char>(bytes).subspan(from));
    if (!chunk.is_complete) return failure("is truncated: a PNG ends with the chunk IEND");
    if (!chunk.is_intact) return failure("is damaged: a PNG chunk's checksum does not fit");
    if (from == signature_size) {
      if (chunk.type != "IHDR") return failure("has a broken PNG header");
      if (Diagnostics found = check_header(chunk.data, header); found.has_errors()) return found;
    }
    is_ended = chunk.type == "IEND";
    if (chunk.type == "IDAT") compressed_bytes += chunk.data.size();
    const std::size_t size = chunk.whole.size();
    if (is_needed(chunk.type)) {
      std::copy(chunk.whole.begin(), chunk.whole.end(),
                bytes.begin() + static_cast<std::ptrdiff_t>(to));
      to += size;
    }
    from += size;
  }
  if (Diagnostics found = check_amount(header, compressed_bytes); found.has_errors()) return found;
  bytes.resize(to);
  return bytes;
}

}  // namespace candela
