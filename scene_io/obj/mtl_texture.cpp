#include "scene_io/obj/mtl_texture.h"

#include <array>

#include <fmt/format.h>

#include "scene_io/text/number.h"
#include "scene_io/text/path.h"

namespace candela::obj {
namespace {

struct Option {
  std::string_view name;
  int least_arguments;
  int most_arguments;    // those beyond the least are taken only while they are numbers
  double no_effect = 0;  // numbers of an option left out that change nothing
};
constexpr std::array<Option, 13> options{{{"-bm", 1, 1},
                                          {"-clamp", 1, 1},
                                          {"-imfchan", 1, 1},
                                          {"-blendu", 1, 1},
                                          {"-blendv", 1, 1},
                                          {"-boost", 1, 1},
                                          {"-cc", 1, 1},
                                          {"-colorspace", 1, 1},
                                          {"-mm", 2, 2, 0},
                                          {"-o", 1, 3, 0},
                                          {"-s", 1, 3, 1},
                                          {"-t", 1, 3, 0},
                                          {"-texres", 1, 1}}};

const Option* find_option(std::string_view word) {
  for (const Option& option : options) {
    if (option.name == word) return &option;
  }
  return word == "-type" ? &options[7] : nullptr;
}

class TextureParser {
 public:
  TextureParser(const text::Source& source, text::Cursor arguments, bool warns,
                Diagnostics& diagnostics)
      : source_(source), at_(arguments), warns_(warns), diagnostics_(diagnostics) {}

  std::optional<MtlTexture> parse(const std::string& mtl_path) {
    while (true) {
      text::Cursor ahead = at_;
      const std::string_view word = ahead.next_word();
      const Option* const option = find_option(word);
      if (option == nullptr) break;
      at_ = ahead;
      if (!take(*option, word)) return std::nullopt;
    }
    at_.skip_blanks();
    const std::string_view name = text::trimmed(at_.rest());
    if (name.empty()) {
      say(Severity::Error, at_.position(), "no file is named; expected the name of an image");
      return std::nullopt;
    }
    resolve(mtl_path, name);
    return std::move(texture_);
  }

 private:
  void say(Severity severity, const char* at, std::string message) {
    const auto offset = static_cast<std::size_t>(at - source_.text.data());
    diagnostics_.add(text::diagnose(source_, offset, severity, std::move(message)));
  }

  bool take(const Option& option, std::string_view word) {
    const bool needs_numbers = option.name != "-clamp" && option.name != "-imfchan" &&
                               option.name != "-blendu" && option.name != "-blendv" &&
                               option.name != "-cc" && option.name != "-colorspace";
    bool is_default = true;
    for (int i = 0; i < option.most_arguments; ++i) {
      text::Cursor ahead = at_;
      const std::string_view argument = ahead.next_word();
      const text::Number<double> number = text::parse_double(argument);
      if (i >= option.least_arguments && !number) break;
      if (argument.empty() || (needs_numbers && !number)) {
        say(Severity::Error, argument.data(),
            fmt::format("{} {}; expected a number after '{}'", text::quoted(argument),
                        text::describe(text::NumberFault::Malformed), word));
        return false;
      }
      at_ = ahead;
      set(option, argument, number.value);
      is_default = is_default && number.value == (option.name == "-mm" ? i : option.no_effect);
    }
    const bool moves_texture =
        option.name == "-o" || option.name == "-s" || option.name == "-t" || option.name == "-mm";
    if (warns_ && moves_texture && !is_default) {
      say(Severity::Warning, word.data(), fmt::format("texture option '{}' is left out", word));
    }
    return true;
  }

  void set(const Option& option, std::string_view argument, double number) {
    if (option.name == "-bm") texture_.bump_multiplier = number;
    if (option.name == "-clamp") texture_.is_clamped = text::equal_ignoring_case(argument, "on");
    if (option.name == "-imfchan") texture_.channel = text::to_lower(argument[0]);
  }

  void resolve(const std::string& mtl_path, std::string_view name) {
    const text::ResolvedPath resolved = text::resolve_path(mtl_path, name);
    const auto offset = static_cast<std::size_t>(name.data() - source_.text.data());
    texture_.path = resolved.path;
    texture_.span = text::span_at(source_, offset);
    if (resolved.has_other_case) {
      say(Severity::Note, name.data(),
          fmt::format("{} is spelled {} on disk", text::quoted(name), text::quoted(resolved.path)));
    }
  }

  const text::Source& source_;
  text::Cursor at_;
  bool warns_;
  Diagnostics& diagnostics_;
  MtlTexture texture_;
};

}  // namespace

std::optional<MtlTexture> parse_texture(const std::string& mtl_path, const text::Source& source,
                                        text::Cursor arguments, bool warns_of_options,
                                        Diagnostics& diagnostics) {
  return TextureParser(source, arguments, warns_of_options, diagnostics).parse(mtl_path);
}

}  // namespace candela::obj
