// Words of a text, one after another: blanks, words and lines. What a word means is the format's.
// A back-slash at the end of a line makes the next line part of it (a continuation).
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
[[nodiscard]] constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Blanks and lines' ends off both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

// A name that goes on to the end of its line, without a comment behind it: names may hold blanks
// and a '#' ("Material #25"), but seldom one between blanks.
[[nodiscard]] std::string_view without_comment(std::string_view name);

// A place in a text that only moves forward. A copy of it is a look ahead.
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

  // Past blanks and continuations, not past the line's end.
  constexpr void skip_blanks() {
    while (at_ != end_) {
      if (is_blank(*at_)) {
        ++at_;
      } else if (const std::size_t length = continuation_length(at_); length > 0) {
        at_ += length;
      } else {
        return;
      }
    }
  }

  // Past blanks, continuations and lines' ends.
  constexpr void skip_spaces() {
    for (skip_blanks(); at_ != end_ && *at_ == '\n'; skip_blanks()) ++at_;
  }

  // The next word of the line after blanks; empty at the line's end.
  constexpr std::string_view next_word() {
    skip_blanks();
    const char* const begin = at_;
    while (at_ != end_ && !is_space(*at_) && continuation_length(at_) == 0) ++at_;
    return {begin, static_cast<std::size_t>(at_ - begin)};
  }

  // From here to the line's end, continued lines with it, and past its '\n'. Comments, from a '#'
  // that begins the line or stands between blanks, do not continue: their last character may be the
  // end of a folder's name.
  [[nodiscard]] std::string_view next_logical_line();

 private:
  // Length of the back-slash, '\r' and '\n' at `at`; 0 where there is no continuation.
  [[nodiscard]] constexpr std::size_t continuation_length(const char* at) const {
    if (*at != '\\') return 0;
    const std::size_t left = static_cast<std::size_t>(end_ - at);
    if (left > 1 && at[1] == '\n') return 2;
    return left > 2 && at[1] == '\r' && at[2] == '\n' ? 3 : 0;
  }

  const char* at_ = nullptr;
  const char* end_ = nullptr;
};

}  // namespace candela::text
