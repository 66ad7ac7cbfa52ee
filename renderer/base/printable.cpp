#include "renderer/base/printable.h"

#include <algorithm>

namespace candela {
namespace {

// Of C0 and C1.
bool is_control(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  if (character.size() == 1) return byte(0) < 0x20 || byte(0) == 0x7f;
  return character.size() == 2 && byte(0) == 0xC2 && byte(1) < 0xA0;
}

// In bytes, of the character of UTF-8 that the text begins with; 0 where it begins with none.
std::size_t character_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) return 1;
  if (lead < 0xC2 || lead > 0xF4) return 0;
  const std::size_t length = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  const std::string_view others = text.substr(1, length - 1);
  const bool is_whole = others.size() == length - 1 &&
                        std::all_of(others.begin(), others.end(), is_utf8_continuation);
  return is_whole ? length : 0;
}

}  // namespace

bool is_utf8_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

std::string printable(std::string_view text, char replacement) {
  std::string clean;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
    if (length == 0 || is_control(character))
      clean += replacement;
    else
      clean += character;
    text.remove_prefix(character.size());
  }
  return clean;
}

}  // namespace candela
