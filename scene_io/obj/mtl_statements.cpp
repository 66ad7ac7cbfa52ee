#include "scene_io/obj/mtl_statements.h"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "renderer/base/letter_case.h"
#include "scene_io/obj/mtl_texture.h"
#include "scene_io/text/cursor.h"
#include "scene_io/text/number.h"

namespace candela::obj {
namespace {

using text::Cursor;

template <class Value>
struct Keyword {
  std::string_view word;
  std::optional<Value> MtlStatements::*member;
  bool is_lab;  // has a meaning with MtlUse::Lab
};
constexpr std::array<Keyword<Vec3d>, 4> colours{{{"Kd", &MtlStatements::kd, true},
                                                 {"Ks", &MtlStatements::ks, true},
                                                 {"Ke", &MtlStatements::ke, false},
                                                 {"Tf", &MtlStatements::tf, false}}};
constexpr std::array<Keyword<double>, 6> scalars{{{"Ns", &MtlStatements::ns, true},
                                                  {"d", &MtlStatements::d, true},
                                                  {"Tr", &MtlStatements::tr, true},
                                                  {"Ni", &MtlStatements::ni, false},
                                                  {"Pr", &MtlStatements::pr, false},
                                                  {"Pm", &MtlStatements::pm, false}}};
constexpr std::array<Keyword<MtlTexture>, 9> maps{{{"map_Kd", &MtlStatements::map_kd, true},
                                                   {"map_Ke", &MtlStatements::map_ke, false},
                                                   {"map_Ks", &MtlStatements::map_ks, true},
                                                   {"map_Bump", &MtlStatements::bump, true},
                                                   {"bump", &MtlStatements::bump, true},
                                                   {"map_d", &MtlStatements::map_d, false},
                                                   {"map_opacity", &MtlStatements::map_d, false},
                                                   {"map_Pr", &MtlStatements::map_pr, false},
                                                   {"norm", &MtlStatements::norm, false}}};
// Known, and without meaning here.
constexpr std::array<std::string_view, 21> silent{
    "Ka",     "map_Ka", "map_Ns",  "refl",      "map_refl", "disp",    "map_disp",
    "decal",  "Km",     "Ps",      "Pc",        "Pcr",      "aniso",   "anisor",
    "map_Ps", "map_Tr", "map_aat", "sharpness", "map_Pc",   "map_Pcr", "map_Tf"};
// Known, and a loss with MtlUse::Full.
constexpr std::array<std::string_view, 1> lost{"map_Pm"};

template <class Table>
auto find_keyword(const Table& table, std::string_view word) {
  return std::find_if(table.begin(), table.end(),
                      [&](const auto& entry) { return equal_ignoring_case(entry.word, word); });
}

template <std::size_t Count>
bool is_among(const std::array<std::string_view, Count>& words, std::string_view word) {
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view w) { return equal_ignoring_case(w, word); });
}

// Of what a statement says: of its line, or before a comment.
bool is_end(std::string_view word) {
  return word.empty() || word[0] == '#';
}

class StatementParser {
 public:
  StatementParser(const std::string& path, const text::Source& source, MtlUse use,
                  Diagnostics& diagnostics)
      : path_(path), source_(source), use_(use), diagnostics_(diagnostics) {}

  std::vector<MtlStatements> run() {
    Cursor lines(source_.text);
    while (!lines.at_end() && !diagnostics_.is_full()) {
      Cursor line(lines.next_logical_line());
      const std::string_view word = line.next_word();
      if (!is_end(word)) parse_statement(word, line);
    }
    return std::move(materials_);
  }

 private:
  void parse_statement(std::string_view word, Cursor& line) {
    if (equal_ignoring_case(word, "newmtl")) return begin_material(word, line);
    if (materials_.empty()) {
      say_lost(word);
    } else if (equal_ignoring_case(word, "illum")) {
      parse_illum(line);
    } else if (const auto colour = find_keyword(colours, word); colour != colours.end()) {
      if (is_used(colour->is_lab)) parse_colour(word, line, materials_.back().*(colour->member));
    } else if (const auto scalar = find_keyword(scalars, word); scalar != scalars.end()) {
      if (is_used(scalar->is_lab)) parse_scalar(word, line, materials_.back().*(scalar->member));
    } else if (const auto map = find_keyword(maps, word); map != maps.end()) {
      if (is_used(map->is_lab)) parse_map(line, materials_.back().*(map->member));
    } else if (!is_among(silent, word)) {
      note_other(word);
    }
  }

  [[nodiscard]] bool is_used(bool is_lab) const { return is_lab || use_ == MtlUse::Full; }

  void say(Severity severity, const char* at, std::string message) {
    const auto offset = static_cast<std::size_t>(at - source_.text.data());
    text::report(diagnostics_, source_, offset, severity, std::move(message));
  }

  void begin_material(std::string_view word, Cursor& line) {
    line.skip_blanks();
    const std::string_view name = text::trimmed(line.rest());
    if (name.empty()) say(Severity::Error, word.data(), "a material without a name");
    MtlStatements material;
    material.name = name;
    material.span = span_at_(static_cast<std::size_t>(word.data() - source_.text.data()));
    if (!names_.insert(name).second) {
      say(Severity::Warning, word.data(),
          fmt::format("material {} is defined again; the first definition counts",
                      text::quoted(name)));
    }
    materials_.push_back(std::move(material));
  }

  // `count` others stand before it.
  std::optional<double> parse_number(std::string_view keyword, std::string_view word,
                                     std::size_t count = 0, std::string_view expected = "1") {
    if (is_end(word)) {
      say(Severity::Error, word.data(), text::too_few_numbers(keyword, count, expected));
    } else if (const text::Number<double> number = text::parse_double(word)) {
      return number.value;
    } else {
      say(Severity::Error, word.data(),
          fmt::format("{} {}; expected a number after '{}'", text::quoted(word),
                      text::describe(number.fault), keyword));
    }
    return std::nullopt;
  }

  // Three numbers, or one for all.
  void parse_colour(std::string_view keyword, Cursor& line, std::optional<Vec3d>& colour) {
    Vec3d value{0.0};
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = line.next_word();
      if (i == 0 && (word == "spectral" || word == "xyz")) {
        return say(Severity::Warning, word.data(),
                   fmt::format("'{}' is left out; expected three numbers", word));
      }
      if (i == 1 && is_end(word)) {
        value = Vec3d{value.x};
        break;
      }
      const std::optional<double> number =
          parse_number(keyword, word, static_cast<std::size_t>(i), "3, or 1 for all");
      if (!number) return;
      value[i] = *number;
    }
    colour = value;
  }

  void parse_scalar(std::string_view keyword, Cursor& line, std::optional<double>& scalar) {
    std::string_view word = line.next_word();
    if (word == "-halo") word = line.next_word();
    if (const std::optional<double> number = parse_number(keyword, word)) scalar = number;
  }

  void parse_illum(Cursor& line) {
    if (use_ != MtlUse::Full) return;
    const std::optional<double> number = parse_number("illum", line.next_word());
    if (number) materials_.back().illum = static_cast<int>(std::clamp(*number, -1.0, 11.0));
  }

  void parse_map(Cursor& line, std::optional<MtlTexture>& map) {
    const TextureContext context{texture_names_, span_at_, use_ == MtlUse::Full, diagnostics_};
    if (auto texture = parse_texture(source_, line, context)) map = std::move(texture);
  }

  void say_lost(std::string_view word) {
    if (!is_lost_said_)
      say(Severity::Warning, word.data(),
          fmt::format("{} stands before the first 'newmtl': what stands there is left out",
                      text::quoted(word)));
    is_lost_said_ = true;
  }

  // Each once a file.
  void note_other(std::string_view word) {
    const bool is_loss = is_among(lost, word);
    if ((is_loss && use_ != MtlUse::Full) || !others_.insert(word).second) return;
    if (is_loss) {
      return say(Severity::Warning, word.data(),
                 fmt::format("'{}' is left out: only a factor is supported here", word));
    }
    const bool is_kept = text::is_kept(diagnostics_, Severity::Warning);
    say(Severity::Warning, word.data(),
        fmt::format("unknown statement {} is left out{}", text::quoted(word),
                    is_kept ? did_you_mean(word, known_words()) : ""));
  }

  static std::vector<std::string_view> known_words() {
    std::vector<std::string_view> words{"newmtl", "illum"};
    for (const auto& entry : colours) words.push_back(entry.word);
    for (const auto& entry : scalars) words.push_back(entry.word);
    for (const auto& entry : maps) words.push_back(entry.word);
    return words;
  }

  const std::string& path_;
  const text::Source& source_;
  MtlUse use_;
  Diagnostics& diagnostics_;
  std::vector<MtlStatements> materials_;
  std::set<std::string_view> names_;
  std::set<std::string_view> others_;
  bool is_lost_said_ = false;
  text::SpanFinder span_at_{source_};
  TextureNames texture_names_{path_};
};

}  // namespace

std::vector<MtlStatements> parse_mtl_statements(const std::string& path, const text::Source& source,
                                                MtlUse use, Diagnostics& diagnostics) {
  return StatementParser(path, source, use, diagnostics).run();
}

}  // namespace candela::obj
