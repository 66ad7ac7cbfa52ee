#include "scene_io/pbrt/write/directive.h"

#include <fmt/format.h>

#include "scene_io/pbrt/token.h"

namespace candela::pbrt {
namespace {

char escape_of(char c) {
  switch (c) {
    case '\n':
      return 'n';
    case '\t':
      return 't';
    case '\r':
      return 'r';
    case '\b':
      return 'b';
    case '\f':
      return 'f';
    case '"':
    case '\\':
      return c;
    default:
      return '\0';
  }
}

}  // namespace

std::string in_quotes(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const char escape = escape_of(c);
    if (escape != '\0') quoted += '\\';
    quoted += escape != '\0' ? escape : c;
  }
  return quoted + '"';
}

std::string value_text(double number) {
  return fmt::format("{}", number);
}
std::string value_text(int number) {
  return fmt::format("{}", number);
}
std::string value_text(bool truth) {
  return truth ? "true" : "false";
}
std::string value_text(const Vec3d& triple) {
  return fmt::format("[ {} {} {} ]", triple.x, triple.y, triple.z);
}
std::string value_text(const std::vector<double>& numbers) {
  std::string list = "[";
  for (const double number : numbers) list += fmt::format(" {}", number);
  return list + " ]";
}
std::string value_text(const char* text) {
  return in_quotes(text);
}
std::string value_text(const std::string& text) {
  return in_quotes(text);
}
std::string value_text(const std::vector<std::string>& texts) {
  std::string list = "[";
  for (const std::string& text : texts) list += ' ' + in_quotes(text);
  return list + " ]";
}

std::string matrix_text(const Transform& transform) {
  std::string text = "[";
  for (int c = 0; c < 3; ++c)
    text += fmt::format(" {} {} {} 0 ", transform.linear[c].x, transform.linear[c].y,
                        transform.linear[c].z);
  const Vec3d& t = transform.translation;
  return text + fmt::format(" {} {} {} 1 ]", t.x, t.y, t.z);
}

Directive::Directive(std::string_view name, std::string_view word)
    : known_(fmt::format("{} {}", name, in_quotes(word))) {}

std::string Directive::text(std::string_view indentation) const {
  std::string lines = fmt::format("{}{}\n", indentation, known_);
  if (has_own()) lines += fmt::format("{}  {}{}\n", indentation, own_mark, own_);
  return lines;
}

}  // namespace candela::pbrt
