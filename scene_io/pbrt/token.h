// The tokens of a pbrt file: words, quoted strings and brackets between blanks and comments (from
// '#' to the line's end, which is '\n' or '\r'). What stands behind `#candela:` is read, while pbrt
// takes it for a comment: parameters for what pbrt's own cannot say (docs/pbrt.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "scene_io/text/cursor.h"

namespace candela::pbrt {

inline constexpr std::string_view own_mark = "#candela:";

enum class TokenKind : std::uint8_t {
  End,
  Word,    // a directive, a number, true or false
  String,  // between quotes
  Open,    // [
  Close,   // ]
  Broken,  // a quote that nothing closes on its line
};

struct Token {
  TokenKind kind = TokenKind::End;
  std::string_view text;   // of strings without their quotes, as written: see unescaped()
  std::size_t offset = 0;  // of the first byte
};

class Tokenizer {
 public:
  explicit Tokenizer(std::string_view text) : text_(text), cursor_(text) {}

  Token next();
  // The token that next() will give.
  [[nodiscard]] Token peek() const { return Tokenizer(*this).next(); }

 private:
  void skip_to_token();
  [[nodiscard]] Token read_string(std::size_t offset);

  std::string_view text_;
  text::Cursor cursor_;
};

// In quotes, for messages; what is no word of the file in words of ours.
[[nodiscard]] std::string described(const Token& token);

// A string with its escapes (\n \t \r \b \f \\ \" \') replaced.
[[nodiscard]] std::string unescaped(std::string_view text);

}  // namespace candela::pbrt
