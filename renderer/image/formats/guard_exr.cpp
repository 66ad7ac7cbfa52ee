// [OpenEXR]: magic, version and flags, attributes (name, type, size, value) up to an empty name,
// then a table of 8 bytes for each chunk of lines or tile.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "renderer/image/formats/byte_cursor.h"
#include "renderer/image/formats/guard.h"

namespace candela {
namespace {

constexpr std::uint32_t tiled_flag = 0x200;
constexpr std::uint32_t deep_flag = 0x800;
constexpr std::uint32_t multi_part_flag = 0x1000;
constexpr std::uint64_t largest_tile_bytes = std::uint64_t{1} << 28;

struct ExrHeader {
  std::int64_t width = 0, height = 0;
  std::uint64_t tile_width = 0, tile_height = 0;
  std::size_t channel_bytes = 0;  // of the list that names them: 18 or more a channel
  std::size_t compression = 0;
  bool has_other_primaries = false;
};

// x and y of red, green, blue and white [BT.709]; "chromaticities" holds them as floats.
bool are_of_rec709(ByteCursor& cursor) {
  constexpr std::array<float, 8> rec709{.64f, .33f, .3f, .6f, .15f, .06f, .3127f, .329f};
  return std::ranges::all_of(rec709, [&](float coordinate) {
    return std::abs(std::bit_cast<float>(cursor.u32_little()) - coordinate) < 2e-3f;
  });
}

void read_attribute(std::string_view name, std::span<const unsigned char> value,
                    ExrHeader& header) {
  ByteCursor cursor(value);
  if (name == "dataWindow") {
    const std::int64_t x0 = cursor.i32_little(), y0 = cursor.i32_little();
    const std::int64_t x1 = cursor.i32_little(), y1 = cursor.i32_little();
    header.width = x1 - x0 + 1;
    header.height = y1 - y0 + 1;
  } else if (name == "tiles") {
    header.tile_width = cursor.u32_little();
    header.tile_height = cursor.u32_little();
  } else if (name == "channels") {
    header.channel_bytes = value.size();
  } else if (name == "compression") {
    header.compression = cursor.u8();
  } else if (name == "chromaticities") {
    header.has_other_primaries = !are_of_rec709(cursor);
  }
}

// Lines in a chunk by the number of the compression: none RLE ZIPS ZIP PIZ PXR24 B44 B44A DWAA
// DWAB.
std::uint64_t lines_a_chunk(std::size_t compression) {
  constexpr std::array<std::uint64_t, 10> lines{1, 1, 1, 16, 32, 16, 32, 32, 32, 256};
  return compression < lines.size() ? lines[compression] : 256;
}

std::uint64_t divided_upwards(std::uint64_t a, std::uint64_t b) {
  return (a + b - 1) / b;
}

Diagnostics check_tiles(const ExrHeader& header) {
  const std::uint64_t side = std::uint64_t{1} << 20;
  const bool is_sane = header.tile_width > 0 && header.tile_height > 0 &&
                       header.tile_width <= side && header.tile_height <= side;
  const std::uint64_t channels = header.channel_bytes / 18 + 1;
  if (is_sane && header.tile_width * header.tile_height <= largest_tile_bytes / (4 * channels))
    return {};
  return failure(
      fmt::format("claims tiles of {} x {} pixels", header.tile_width, header.tile_height));
}

std::uint64_t chunk_count(const ExrHeader& header, bool is_tiled) {
  const auto width = static_cast<std::uint64_t>(header.width);
  const auto height = static_cast<std::uint64_t>(header.height);
  if (!is_tiled) return divided_upwards(height, lines_a_chunk(header.compression));
  return divided_upwards(width, header.tile_width) * divided_upwards(height, header.tile_height);
}

}  // namespace

Result<Bytes> guard_exr(Bytes bytes) {
  ByteCursor cursor(bytes);
  cursor.skip(4);
  const std::uint32_t flags = cursor.u32_little();
  if ((flags & deep_flag) != 0) return failure("is a deep EXR; flat ones are read");
  if ((flags & multi_part_flag) != 0) return failure("is a multi-part EXR; single parts are read");
  ExrHeader header;
  for (std::string_view name = cursor.text(); cursor.is_good() && !name.empty();
       name = cursor.text()) {
    (void)cursor.text();  // the attribute's type
    const std::uint32_t size = cursor.u32_little();
    read_attribute(name, cursor.take(size), header);
  }
  if (!cursor.is_good()) return failure("is truncated: it ends within an EXR's header");
  if (header.width <= 0 || header.height <= 0) return failure("has a broken EXR header");
  const bool is_tiled = (flags & tiled_flag) != 0;
  if (is_tiled) {
    if (Diagnostics found = check_tiles(header); found.has_errors()) return found;
  }
  if (chunk_count(header, is_tiled) > cursor.remaining() / 8)
    return failure(fmt::format("claims {} x {} pixels, which its {} bytes cannot hold",
                               header.width, header.height, bytes.size()));
  Diagnostics found;
  if (header.has_other_primaries)
    found.warning({},
                  "has other primaries (chromaticities) than Rec.709's, as which its numbers "
                  "are taken");
  return {std::move(bytes), std::move(found)};
}

}  // namespace candela
