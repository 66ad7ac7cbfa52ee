#include "scene_io/pbrt/parameter.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/counted.h"
#include "scene_io/pbrt/directives.h"
#include "scene_io/text/number.h"

namespace candela::pbrt {
namespace {

struct NamedType {
  std::string_view name;
  ParameterType type;
};

// The first name of a type is what name_of() gives.
constexpr std::array<NamedType, 19> named_types{{{"float", ParameterType::Float},
                                                 {"integer", ParameterType::Integer},
                                                 {"bool", ParameterType::Bool},
                                                 {"string", ParameterType::String},
                                                 {"texture", ParameterType::Texture},
                                                 {"point2", ParameterType::Point2},
                                                 {"vector2", ParameterType::Vector2},
                                                 {"point3", ParameterType::Point3},
                                                 {"vector3", ParameterType::Vector3},
                                                 {"normal", ParameterType::Normal},
                                                 {"rgb", ParameterType::Rgb},
                                                 {"xyz", ParameterType::Xyz},
                                                 {"spectrum", ParameterType::Spectrum},
                                                 {"blackbody", ParameterType::Blackbody},
                                                 {"point", ParameterType::Point3},
                                                 {"vector", ParameterType::Vector3},
                                                 {"normal3", ParameterType::Normal},
                                                 {"color", ParameterType::Rgb},
                                                 {"int", ParameterType::Integer}}};

std::vector<std::string_view> type_names() {
  std::vector<std::string_view> names;
  for (const NamedType& named : named_types) names.push_back(named.name);
  return names;
}

bool takes_strings(ParameterType type) {
  return type == ParameterType::String || type == ParameterType::Texture ||
         type == ParameterType::Spectrum;
}
bool takes_numbers(ParameterType type) {
  return type != ParameterType::String && type != ParameterType::Texture;
}

std::string_view expected_value(ParameterType type) {
  switch (type) {
    case ParameterType::Bool:
      return "true or false";
    case ParameterType::String:
      return "a string in quotes";
    case ParameterType::Texture:
      return "the name of a texture in quotes";
    case ParameterType::Spectrum:
      return "a number, or a name in quotes";
    case ParameterType::Integer:
      return "an integer";
    default:
      return "a number";
  }
}

class ListReader {
 public:
  ListReader(Tokenizer& tokens, const SourceFile& file, const Report& report)
      : tokens_(tokens), file_(file), report_(report) {}

  ParameterList read() {
    ParameterList list;
    while (tokens_.peek().kind != TokenKind::End && tokens_.peek().kind != TokenKind::Word) {
      Parameter parameter;
      if (!read_parameter(parameter))
        skip_to_directive();
      else
        add(std::move(parameter), list);
    }
    return list;
  }

 private:
  // As in pbrt the last of several counts.
  void add(Parameter parameter, ParameterList& list) {
    const auto [at, is_new] = index_of_.try_emplace(parameter.name, list.size());
    if (is_new) return list.push_back(std::move(parameter));
    report_.warning(parameter.place, fmt::format("{} is given twice; the last one counts",
                                                 text::quoted(parameter.name)));
    list[at->second] = std::move(parameter);
  }

  bool fail(std::size_t offset, std::string message) {
    report_.error({&file_, offset}, std::move(message));
    return false;
  }

  bool read_parameter(Parameter& parameter) {
    const Token declaration = tokens_.next();
    if (declaration.kind == TokenKind::Broken)
      return fail(declaration.offset, "a quote that is not closed on its line");
    if (declaration.kind != TokenKind::String)
      return fail(declaration.offset,
                  fmt::format("found {}, expected a parameter like \"float radius\" or a directive",
                              text::quoted(declaration.text)));
    return read_declaration(declaration, parameter) && read_values(parameter);
  }

  bool read_declaration(const Token& declaration, Parameter& parameter) {
    text::Cursor words(declaration.text);
    const std::string_view type_name = words.next_word();
    const std::string_view name = words.next_word();
    parameter.place = {&file_, declaration.offset};
    if (type_name.empty() || name.empty() || !words.next_word().empty())
      return fail(declaration.offset,
                  fmt::format("found \"{}\", expected a type and a name, like \"float radius\"",
                              unquoted(declaration.text)));
    const auto type = parameter_type_named(type_name);
    if (!type)
      return fail(declaration.offset,
                  fmt::format("{} is not a type of parameters{}", text::quoted(type_name),
                              did_you_mean(type_name, type_names())));
    parameter.type = *type;
    parameter.name = unescaped(name);
    return true;
  }

  static std::string unquoted(std::string_view word) {
    const std::string quoted = text::quoted(word);
    return quoted.substr(1, quoted.size() - 2);
  }

  bool read_values(Parameter& parameter) {
    const Token first = tokens_.peek();
    if (ends_values(first))
      return fail_at(parameter.place.offset, parameter, first, expected_value(parameter.type));
    tokens_.next();
    if (first.kind != TokenKind::Open) return read_value(first, parameter);
    while (true) {
      const Tokenizer before = tokens_;
      const Token token = tokens_.next();
      if (token.kind == TokenKind::Close) return true;
      if (ends_values(token)) {
        tokens_ = before;
        return fail_at(first.offset, parameter, token, "the ] of this list");
      }
      if (!read_value(token, parameter)) return false;
    }
  }

  // What no value is, whatever is missing before it.
  static bool ends_values(const Token& token) {
    return token.kind == TokenKind::End || begins_directive(token);
  }

  bool fail_at(std::size_t offset, const Parameter& parameter, const Token& found,
               std::string_view expected) {
    return fail(offset, fmt::format("\"{} {}\": found {}, expected {}", name_of(parameter.type),
                                    parameter.name, described(found), expected));
  }

  bool read_value(const Token& token, Parameter& parameter) {
    if (token.kind == TokenKind::Broken)
      return fail(token.offset, "a quote that is not closed on its line");
    if (parameter.type == ParameterType::Bool && is_truth(token)) {
      parameter.numbers.push_back(token.text == "true" ? 1 : 0);
      return true;
    }
    if (token.kind == TokenKind::String && takes_strings(parameter.type)) {
      parameter.strings.push_back(unescaped(token.text));
      return true;
    }
    if (token.kind == TokenKind::Word && takes_numbers(parameter.type) &&
        parameter.type != ParameterType::Bool)
      return read_number(token, parameter);
    return fail_at(token.offset, parameter, token, expected_value(parameter.type));
  }

  // pbrt-v3 puts quotes around them.
  static bool is_truth(const Token& token) {
    return (token.kind == TokenKind::Word || token.kind == TokenKind::String) &&
           (token.text == "true" || token.text == "false");
  }

  bool read_number(const Token& token, Parameter& parameter) {
    const text::Number<double> number = text::parse_double(token.text);
    if (!number)
      return fail(token.offset,
                  fmt::format("\"{} {}\": {} {}, expected {}", name_of(parameter.type),
                              parameter.name, text::quoted(token.text), describe(number.fault),
                              expected_value(parameter.type)));
    parameter.numbers.push_back(number.value);
    return true;
  }

  // A word with a capital letter: no value begins with one.
  void skip_to_directive() {
    const auto is_directive = [](const Token& token) {
      return token.kind == TokenKind::Word && token.text[0] >= 'A' && token.text[0] <= 'Z';
    };
    while (tokens_.peek().kind != TokenKind::End && !is_directive(tokens_.peek())) tokens_.next();
  }

  Tokenizer& tokens_;
  const SourceFile& file_;
  const Report& report_;
  std::unordered_map<std::string, std::size_t> index_of_;  // in the list, by name
};

}  // namespace

std::optional<ParameterType> parameter_type_named(std::string_view name) {
  for (const NamedType& named : named_types)
    if (named.name == name) return named.type;
  return std::nullopt;
}

std::string_view name_of(ParameterType type) {
  return std::find_if(named_types.begin(), named_types.end(),
                      [&](const NamedType& named) { return named.type == type; })
      ->name;
}

std::size_t value_count(const Parameter& parameter) {
  return std::max(parameter.numbers.size(), parameter.strings.size());
}

std::string describe_count(const Parameter& parameter) {
  return counted(value_count(parameter), "value");
}

std::string describe_numbers(const Parameter& parameter) {
  return fmt::format("[{}]", fmt::join(parameter.numbers, ", "));
}

void append_missing(const ParameterList& defaults, ParameterList& list) {
  std::unordered_set<std::string> names;
  for (const Parameter& own : list) names.insert(own.name);
  for (const Parameter& parameter : defaults)
    if (!names.contains(parameter.name)) list.push_back(parameter);
}

ParameterList read_parameters(Tokenizer& tokens, const SourceFile& file, const Report& report) {
  return ListReader(tokens, file, report).read();
}

}  // namespace candela::pbrt
