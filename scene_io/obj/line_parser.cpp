#include "scene_io/obj/line_parser.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "renderer/base/counted.h"
#include "scene_io/mesh/float_direction.h"
#include "scene_io/obj/corner_parser.h"
#include "scene_io/text/number.h"

namespace candela::obj {
namespace {

using text::Cursor;

// Kinds of statements remembered a chunk; a file of random words would have no end of them.
constexpr std::size_t max_left_out = 64;

class ChunkParser {
 public:
  ChunkParser(std::string_view text, const ChunkTask& task, Chunk& chunk)
      : text_(text), task_(task), seen_(task.before), chunk_(chunk) {}

  void run() {
    Cursor lines(text_);
    while (!lines.at_end() && chunk_.error_count < Diagnostics::most_counted) {
      parse_line(Cursor(lines.next_logical_line()));
    }
  }

 private:
  void parse_line(Cursor line) {
    std::string_view keyword;
    switch (take_statement(line, keyword)) {
      case Statement::Position:
        return parse_position(line);
      case Statement::Uv:
        return parse_uv(line);
      case Statement::Normal:
        return parse_normal(line);
      case Statement::Face:
        return parse_face(line, keyword);
      case Statement::Shape:
        return add_switch(Switch::Kind::Shape, {});
      case Statement::Material:
        return parse_material(line);
      case Statement::Library:
        chunk_.libraries.push_back({rest_of(line), offset_of(keyword.data())});
        return;
      case Statement::LeftOut:
        return note_left_out(keyword);
      case Statement::None:
      case Statement::Silent:
        return;
    }
  }

  // A name, which may hold blanks.
  [[nodiscard]] static std::string_view rest_of(Cursor& line) {
    line.skip_blanks();
    return text::trimmed(line.rest());
  }

  [[nodiscard]] std::size_t offset_of(const char* at) const {
    return chunk_.begin + static_cast<std::size_t>(at - text_.data());
  }

  void error(const char* at, std::string message) {
    if (++chunk_.error_count <= Diagnostics::limit)
      chunk_.findings.push_back({Severity::Error, offset_of(at), std::move(message)});
  }

  // Up to four numbers; false, after an error, where one is malformed or fewer than `least` are
  // there. What follows (colours) is not looked at.
  template <std::size_t Count>
  bool parse_numbers(Cursor& line, std::size_t least, std::string_view statement,
                     std::array<double, Count>& numbers) {
    for (std::size_t i = 0; i < Count; ++i) {
      const std::string_view word = line.next_word();
      if (word.empty() || word[0] == '#') {
        if (i >= least) return true;
        error(word.data(),
              text::too_few_numbers(statement, i,
                                    fmt::format("{}{}", least, least == Count ? "" : " or more")));
        return false;
      }
      const text::Number<double> number = text::parse_double(word);
      if (!number) {
        error(word.data(), fmt::format("{} {}; expected {} numbers after '{}'", text::quoted(word),
                                       text::describe(number.fault), Count, statement));
        return false;
      }
      numbers[i] = number.value;
    }
    return true;
  }

  // A line in error still counts, so that the indices behind it keep their meaning.
  void parse_position(Cursor& line) {
    std::array<double, 3> xyz{};
    parse_numbers(line, 3, "v", xyz);
    task_.data->positions[seen_.positions++] = {xyz[0], xyz[1], xyz[2]};
  }

  void parse_uv(Cursor& line) {
    std::array<double, 2> uv{};
    parse_numbers(line, 1, "vt", uv);
    const auto to_float = [](double x) { return static_cast<float>(std::clamp(x, -1e30, 1e30)); };
    task_.data->uvs[seen_.uvs++] = {to_float(uv[0]), to_float(uv[1])};
  }

  void parse_normal(Cursor& line) {
    std::array<double, 3> xyz{};
    parse_numbers(line, 3, "vn", xyz);
    task_.data->normals[seen_.normals++] = mesh::to_float_direction({xyz[0], xyz[1], xyz[2]});
  }

  void parse_face(Cursor& line, std::string_view keyword) {
    const std::size_t first = chunk_.corners.size();
    const TableSizes sizes{{task_.total.positions, seen_.positions},
                           {task_.total.uvs, seen_.uvs},
                           {task_.total.normals, seen_.normals}};
    bool is_sound = true;
    for (std::string_view word = line.next_word(); !word.empty() && word[0] != '#';
         word = line.next_word()) {
      Corner corner;
      if (const auto fault = parse_corner(word, sizes, corner)) {
        error(word.data() + fault->offset, fault->message);
        is_sound = false;
        break;
      }
      chunk_.corners.push_back(corner);
    }
    const std::size_t count = chunk_.corners.size() - first;
    if (is_sound && count < 3) {
      error(keyword.data(),
            fmt::format("a face of {}; expected 3 or more", counted(count, "corner")));
      is_sound = false;
    }
    if (!is_sound) return chunk_.corners.shorten_to(first);
    chunk_.faces.push_back({static_cast<std::uint32_t>(count),
                            static_cast<std::uint32_t>(keyword.data() - text_.data())});
  }

  void parse_material(Cursor& line) { add_switch(Switch::Kind::Material, rest_of(line)); }

  void add_switch(Switch::Kind kind, std::string_view name) {
    chunk_.switches.push_back({kind, static_cast<std::uint32_t>(chunk_.faces.size()),
                               static_cast<std::uint32_t>(chunk_.corners.size()), name});
  }

  void note_left_out(std::string_view keyword) {
    const auto is_same = [&](const LeftOut& other) { return other.keyword == keyword; };
    if (chunk_.left_out.size() >= max_left_out) return;
    if (std::any_of(chunk_.left_out.begin(), chunk_.left_out.end(), is_same)) return;
    chunk_.left_out.push_back({keyword, offset_of(keyword.data())});
  }

  std::string_view text_;
  const ChunkTask& task_;
  ElementCounts seen_;  // in the file up to the current line
  Chunk& chunk_;
};

Statement statement_of(std::string_view keyword) {
  if (keyword == "v") return Statement::Position;
  if (keyword == "f") return Statement::Face;
  if (keyword == "vn") return Statement::Normal;
  if (keyword == "vt") return Statement::Uv;
  if (keyword == "g" || keyword == "o") return Statement::Shape;
  if (keyword == "s") return Statement::Silent;
  if (keyword == "usemtl") return Statement::Material;
  if (keyword == "mtllib") return Statement::Library;
  return Statement::LeftOut;
}

}  // namespace

Statement take_statement(Cursor& line, std::string_view& keyword) {
  keyword = line.next_word();
  if (keyword.empty() || keyword[0] == '#') return Statement::None;
  return statement_of(keyword);
}

ElementCounts count_elements(std::string_view text) {
  ElementCounts counts;
  Cursor lines(text);
  while (!lines.at_end()) {
    Cursor line(lines.next_logical_line());
    std::string_view keyword;
    const Statement statement = take_statement(line, keyword);
    counts.positions += statement == Statement::Position ? 1 : 0;
    counts.uvs += statement == Statement::Uv ? 1 : 0;
    counts.normals += statement == Statement::Normal ? 1 : 0;
    counts.faces += statement == Statement::Face ? 1 : 0;
  }
  return counts;
}

void parse_chunk(std::string_view text, const ChunkTask& task, Chunk& chunk) {
  ChunkParser(text, task, chunk).run();
}

}  // namespace candela::obj
