#include "scene_io/obj/mtl_texture.h"

#include <array>
#include <cstdint>

#include <fmt/format.h>

#include "renderer/base/letter_case.h"
#include "scene_io/text/number.h"

namespace candela::obj {
namespace {

enum class Takes : std::uint8_t { Words, Numbers };
struct Option {
  std::string_view name;
  Takes takes;
  int least_arguments;
  int most_arguments;    // those beyond the least are taken only while they are numbers
  double no_effect = 0;  // numbers of an option left out that change nothing
};
constexpr std::array<Option, 14> options{{{"-bm", Takes::Numbers, 1, 1},
                                          {"-clamp", Takes::Words, 1, 1},
                                          {"-imfchan", Takes::Words, 1, 1},
                                          {"-blendu", Takes::Words, 1, 1},
                                          {"-blendv", Takes::Words, 1, 1},
                                          {"-boost", Takes::Numbers, 1, 1},
                                          {"-cc", Takes::Words, 1, 1},
                                          {"-colorspace", Takes::Words, 1, 1},
                                          {"-mm", Takes::Numbers, 2, 2, 0},
                                          {"-o", Takes::Numbers, 1, 3, 0},
                                          {"-s", Takes::Numbers, 1, 3, 1},
                                          {"-t", Takes::Numbers, 1, 3, 0},
                                          {"-texres", Takes::Numbers, 1, 1},
                                          {"-type", Takes::Words, 1, 1}}};

const Option* find_option(std::string_view word) {
  for (const Option& option : options)
    if (option.name == word) return &option;
  return nullptr;
}

class TextureParser {
 public:
  TextureParser(const text::Source& source, text::Cursor arguments, const TextureContext& context)
      : source_(source), at_(arguments), context_(context) {}

  std::optional<MtlTexture> parse() {
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
    resolve(name);
    return std::move(texture_);
  }

 private:
  void say(Severity severity, const char* at, std::string message) {
    const auto offset = static_cast<std::size_t>(at - source_.text.data());
    text::report(context_.diagnostics, source_, offset, severity, std::move(message));
  }

  bool take(const Option& option, std::string_view word) {
    bool is_default = true;
    for (int i = 0; i < option.most_arguments; ++i) {
      text::Cursor ahead = at_;
      const std::string_view argument = ahead.next_word();
      const text::Number<double> number = text::parse_double(argument);
      if (i >= option.least_arguments && !number) break;
      if (argument.empty()) {
        say(Severity::Error, argument.data(), fmt::format("nothing stands behind '{}'", word));
        return false;
      }
      if (option.takes == Takes::Numbers && !number) {
        say(Severity::Error, argument.data(),
            fmt::format("{} {}; expected a number after '{}'", text::quoted(argument),
                        text::describe(number.fault), word));
        return false;
      }
      at_ = ahead;
      set(option, argument, number.value);
      is_default = is_default && number.value == (option.name == "-mm" ? i : option.no_effect);
    }
    const bool moves_texture =
        option.name == "-o" || option.name == "-s" || option.name == "-t" || option.name == "-mm";
    if (context_.warns_of_options && moves_texture && !is_default) {
      say(Severity::Warning, word.data(), fmt::format("texture option '{}' is left out", word));
    }
    return true;
  }

  void set(const Option& option, std::string_view argument, double number) {
    if (option.name == "-bm") texture_.bump_multiplier = number;
    if (option.name == "-clamp") texture_.is_clamped = equal_ignoring_case(argument, "on");
    if (option.name == "-imfchan") texture_.channel = to_lower(argument[0]);
  }

  void resolve(std::string_view name) {
    bool is_new = false;
    const text::ResolvedPath* resolved = &context_.names.find(name, is_new);
    const std::string_view bare = text::without_comment(name);
    if (!resolved->is_found && !bare.empty() && bare != name) {
      name = bare;
      resolved = &context_.names.find(name, is_new);
    }
    if (!resolved->is_found) warn_of_options_behind(name);
    texture_.path = resolved->path;
    texture_.span = context_.span_at(static_cast<std::size_t>(name.data() - source_.text.data()));
    if (is_new && resolved->is_substitute())
      say(Severity::Note, name.data(), text::describe_substitute(*resolved, name));
  }

  void warn_of_options_behind(std::string_view name) {
    text::Cursor words(name);
    for (std::string_view word = words.next_word(); !word.empty(); word = words.next_word())
      if (word != name && find_option(word) != nullptr)
        return say(Severity::Warning, word.data(),
                   fmt::format("'{}' behind the name of an image is part of it; options stand "
                               "before it",
                               word));
  }

  const text::Source& source_;
  text::Cursor at_;
  const TextureContext& context_;
  MtlTexture texture_;
};

}  // namespace

const text::ResolvedPath& TextureNames::find(std::string_view name, bool& is_new) {
  const auto [entry, is_inserted] = known_.try_emplace(name);
  is_new = is_inserted;
  if (is_new) entry->second = text::resolve_path(mtl_path_, name);
  return entry->second;
}

std::optional<MtlTexture> parse_texture(const text::Source& source, text::Cursor arguments,
                                        const TextureContext& context) {
  return TextureParser(source, arguments, context).parse();
}

}  // namespace candela::obj
