#include "scene_io/obj/corner_parser.h"

#include <fmt/format.h>

#include "renderer/base/counted.h"
#include "scene_io/text/cursor.h"
#include "scene_io/text/source.h"

namespace candela::obj {
namespace {

// Digits that a 64-bit number surely holds; longer ones are out of range for any table.
constexpr std::size_t max_digits = 18;

struct Table {
  std::string_view what;       // for sentences
  std::string_view statement;  // that fills it
};
constexpr Table positions{"position", "v"};
constexpr Table uvs{"texture coordinate", "vt"};
constexpr Table normals{"normal", "vn"};

std::string out_of_range(std::string_view digits, const Table& table, const TableSize& size) {
  if (digits[0] == '-') {
    return fmt::format("index {} reaches before the first {}: {} '{}' stand{} above this line",
                       digits, table.what, size.above, table.statement, size.above == 1 ? "s" : "");
  }
  return fmt::format("index {} is out of range: the file has {} ('{}')", digits,
                     counted(size.total, table.what), table.statement);
}

// An integer at `at`; moves `at` behind it.
struct IndexParser {
  std::string_view word;
  std::size_t at = 0;
  std::optional<CornerFault> fault;

  [[nodiscard]] bool is_at(char c) const { return at < word.size() && word[at] == c; }

  void fail(std::size_t offset, std::string message) { fault = {offset, std::move(message)}; }

  std::int32_t take(const Table& table, const TableSize& size) {
    const std::size_t begin = at;
    const bool is_backwards = is_at('-');
    if (is_backwards || is_at('+')) ++at;
    const std::size_t first_digit = at;
    std::uint64_t value = 0;
    for (; at < word.size() && text::is_digit(word[at]); ++at) {
      if (at - first_digit < max_digits) {
        value = value * 10 + static_cast<std::uint64_t>(word[at] - '0');
      }
    }
    const std::string_view digits = word.substr(begin, at - begin);
    if (at == first_digit) return fail_as_malformed(begin, table);
    if (value == 0 && at - first_digit <= max_digits) {
      fail(begin, fmt::format("index 0 of a {}: expected 1 for the first, or -1 for the last",
                              table.what));
      return -1;
    }
    const std::uint64_t limit = is_backwards ? size.above : size.total;
    if (value > limit || at - first_digit > max_digits) {
      fail(begin, out_of_range(shortened(digits), table, size));
      return -1;
    }
    return static_cast<std::int32_t>(is_backwards ? size.above - value : value - 1);
  }

  static std::string shortened(std::string_view digits) {
    return fmt::format("{}{}", digits.substr(0, 24), digits.size() > 24 ? "..." : "");
  }

  std::int32_t fail_as_malformed(std::size_t begin, const Table& table) {
    fail(begin, fmt::format("{} is not the index of a {}; expected v, v/vt, v//vn or v/vt/vn",
                            text::quoted(word), table.what));
    return -1;
  }
};

}  // namespace

std::optional<CornerFault> parse_corner(std::string_view word, const TableSizes& sizes,
                                        Corner& corner) {
  corner = {};
  IndexParser parser{word, 0, std::nullopt};
  corner.position = parser.take(positions, sizes.positions);
  if (!parser.fault && parser.is_at('/')) {
    ++parser.at;
    if (parser.at < word.size() && word[parser.at] != '/') {
      corner.uv = parser.take(uvs, sizes.uvs);
    }
    if (!parser.fault && parser.is_at('/')) {
      ++parser.at;
      if (parser.at < word.size()) corner.normal = parser.take(normals, sizes.normals);
    }
  }
  if (!parser.fault && parser.at < word.size()) parser.fail_as_malformed(parser.at, positions);
  return std::move(parser.fault);
}

}  // namespace candela::obj
