#include "scene_io/ply/header.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "scene_io/text/cursor.h"
#include "scene_io/text/number.h"

namespace candela::ply {
namespace {

using text::Cursor;

constexpr std::array<std::pair<std::string_view, Type>, 16> type_names{
    {{"char", Type::Int8},
     {"int8", Type::Int8},
     {"uchar", Type::Uint8},
     {"uint8", Type::Uint8},
     {"short", Type::Int16},
     {"int16", Type::Int16},
     {"ushort", Type::Uint16},
     {"uint16", Type::Uint16},
     {"int", Type::Int32},
     {"int32", Type::Int32},
     {"uint", Type::Uint32},
     {"uint32", Type::Uint32},
     {"float", Type::Float32},
     {"float32", Type::Float32},
     {"double", Type::Float64},
     {"float64", Type::Float64}}};

class HeaderParser {
 public:
  HeaderParser(const text::Source& source, Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics) {}

  std::optional<Header> parse() {
    const std::string_view magic = text::trimmed(next_line());
    if (magic != "ply") return fail(0, "is not a PLY file: expected 'ply' in the first line");
    while (at_ < source_.text.size()) {
      Cursor line(next_line());
      const std::string_view keyword = line.next_word();
      if (keyword == "end_header") return finish();
      if (!parse_statement(keyword, line)) return std::nullopt;
    }
    return fail(source_.text.size(), "the header has no end; expected 'end_header'");
  }

 private:
  // Without the '\n'; no line of a header continues in the next.
  std::string_view next_line() {
    const std::size_t begin = at_;
    const std::size_t newline = std::min(source_.text.find('\n', begin), source_.text.size());
    at_ = std::min(newline + 1, source_.text.size());
    return source_.text.substr(begin, newline - begin);
  }

  std::nullopt_t fail(std::size_t offset, std::string message) {
    diagnostics_.add(text::diagnose(source_, offset, Severity::Error, std::move(message)));
    return std::nullopt;
  }
  bool refuse(std::string_view at, std::string message) {
    fail(static_cast<std::size_t>(at.data() - source_.text.data()), std::move(message));
    return false;
  }

  bool parse_statement(std::string_view keyword, Cursor& line) {
    if (keyword == "format") return parse_format(line);
    if (keyword == "element") return parse_element(keyword, line);
    if (keyword == "property") return parse_property(keyword, line);
    if (keyword == "comment" || keyword == "obj_info" || keyword.empty()) return true;
    return refuse(
        keyword,
        fmt::format("{} in the header; expected 'element', 'property' or 'end_header'{}",
                    text::quoted(keyword),
                    did_you_mean(keyword, {"element", "property", "end_header", "comment"})));
  }

  bool parse_format(Cursor& line) {
    const std::string_view form = line.next_word();
    has_format_ = true;
    if (form == "ascii") {
      header_.form = Form::Ascii;
    } else if (form == "binary_little_endian") {
      header_.form = Form::LittleEndian;
    } else if (form == "binary_big_endian") {
      header_.form = Form::BigEndian;
    } else {
      return refuse(form, fmt::format("format {}; expected ascii, binary_little_endian or "
                                      "binary_big_endian",
                                      text::quoted(form)));
    }
    return true;
  }

  bool parse_element(std::string_view keyword, Cursor& line) {
    Element element;
    element.name = line.next_word();
    element.offset = static_cast<std::size_t>(keyword.data() - source_.text.data());
    const std::string_view word = line.next_word();
    const text::Number<std::int64_t> count = text::parse_integer(word);
    if (element.name.empty() || !count || count.value < 0) {
      return refuse(word, fmt::format("{} is not a count; expected 'element NAME COUNT'",
                                      text::quoted(word)));
    }
    element.count = static_cast<std::uint64_t>(count.value);
    header_.elements.push_back(std::move(element));
    return true;
  }

  bool parse_type(Cursor& line, Type& type) {
    const std::string_view word = line.next_word();
    for (const auto& [name, known] : type_names) {
      if (name == word) {
        type = known;
        return true;
      }
    }
    return refuse(word, fmt::format("{} is not a type; expected one of char, uchar, short, ushort, "
                                    "int, uint, float, double",
                                    text::quoted(word)));
  }

  bool parse_property(std::string_view keyword, Cursor& line) {
    if (header_.elements.empty()) return refuse(keyword, "a property before the first element");
    Property property;
    Cursor ahead = line;
    if (ahead.next_word() == "list") {
      line = ahead;
      Type count_type{};
      if (!parse_type(line, count_type)) return false;
      if (count_type == Type::Float32 || count_type == Type::Float64) {
        return refuse(keyword, "a list whose length is no integer; expected an integer type");
      }
      property.count_type = count_type;
    }
    if (!parse_type(line, property.type)) return false;
    property.name = line.next_word();
    if (property.name.empty()) return refuse(keyword, "a property without a name");
    header_.elements.back().properties.push_back(property);
    return true;
  }

  std::optional<Header> finish() {
    if (!has_format_) {
      return fail(0, "the header says no format; expected 'format ascii 1.0' or the like");
    }
    header_.body = at_;
    return std::move(header_);
  }

  const text::Source& source_;
  Diagnostics& diagnostics_;
  Header header_;
  std::size_t at_ = 0;
  bool has_format_ = false;
};

}  // namespace

std::size_t byte_size(Type type) {
  switch (type) {
    case Type::Int8:
    case Type::Uint8:
      return 1;
    case Type::Int16:
    case Type::Uint16:
      return 2;
    case Type::Int32:
    case Type::Uint32:
    case Type::Float32:
      return 4;
    case Type::Float64:
      return 8;
  }
  return 8;
}

const Property* Element::find(std::string_view property) const {
  for (const Property& p : properties) {
    if (p.name == property) return &p;
  }
  return nullptr;
}

std::optional<Header> parse_header(const text::Source& source, Diagnostics& diagnostics) {
  return HeaderParser(source, diagnostics).parse();
}

}  // namespace candela::ply
