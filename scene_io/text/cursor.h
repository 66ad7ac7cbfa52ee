// Words of a text, one after another: blanks, quotes and lines. What a word means is the format's.
#pragma once

#include <cstddef>
#include <string_view>

namespace candela::text {

[[nodiscard]] constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}
[[nodiscard]] constexpr bool is_space(char c) {
  return c == '\n' || is_blank(c);
}
[[nodiscard]] constexpr char to_lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
[[nodiscard]] bool equal_ignoring_case(std::string_view a, std::string_view b);

// Blanks off both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

// A place in [begin, end) that only moves forward. Copying it is a look ahead.
class Cursor {
 public:
  constexpr Cursor() = default;
  constexpr explicit Cursor(std::string_view text)
      : at_(text.data()), end_(text.data() + text.size()) {}

  [[nodiscard]] constexpr bool at_end() const { return at_ == end_; }
  [[nodiscard]] constexpr char peek() const { return at_ == end_ ? '\0' : *at_; }
  [[nodiscard]] constexpr const char* position() const { return at_; }
  [[nodiscard]] constexpr std::string_view rest() const {
    return {at_, static_cast<std::size_t>(end_ - at_)};
  }
  constexpr void skip(std::size_t count) { at_ += count; }

  // Past blanks; a back-slash at the end of a line (a continuation) is one with the line's end.
  void skip_blanks();
  // Past blanks and lines' ends.
  void skip_spaces();
  // The next word of the line after blanks: up to a blank or the line's end. Empty at its end.
  std::string_view next_word();
  // The next line without its '\n', from here on; continuations are part of it.
  std::string_view next_logical_line();

 private:
  const char* at_ = nullptr;
  const char* end_ = nullptr;
};

}  // namespace candela::text
