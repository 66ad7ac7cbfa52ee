#include "scene_io/pbrt/token.h"

#include <algorithm>

#include "scene_io/text/source.h"

namespace candela::pbrt {
namespace {

bool ends_word(char c) {
  return text::is_space(c) || c == '"' || c == '[' || c == ']' || c == '#';
}

std::size_t word_length(std::string_view rest) {
  const auto end = std::find_if(rest.begin(), rest.end(), ends_word);
  return static_cast<std::size_t>(end - rest.begin());
}

char escaped_character(char c) {
  switch (c) {
    case 'n':
      return '\n';
    case 't':
      return '\t';
    case 'r':
      return '\r';
    case 'b':
      return '\b';
    case 'f':
      return '\f';
    default:
      return c;
  }
}

}  // namespace

void Tokenizer::skip_to_token() {
  for (cursor_.skip_spaces(); cursor_.peek() == '#'; cursor_.skip_spaces()) {
    const std::string_view rest = cursor_.rest();
    const bool is_own = rest.starts_with(own_mark);
    cursor_.skip(is_own ? own_mark.size() : std::min(rest.find_first_of("\r\n"), rest.size()));
  }
}

Token Tokenizer::next() {
  skip_to_token();
  const std::string_view rest = cursor_.rest();
  const std::size_t offset = text_.size() - rest.size();
  if (rest.empty()) return {TokenKind::End, rest, offset};
  if (rest[0] == '"') return read_string(offset);
  if (rest[0] == '[' || rest[0] == ']') {
    cursor_.skip(1);
    return {rest[0] == '[' ? TokenKind::Open : TokenKind::Close, rest.substr(0, 1), offset};
  }
  const std::size_t length = word_length(rest);
  cursor_.skip(length);
  return {TokenKind::Word, rest.substr(0, length), offset};
}

Token Tokenizer::read_string(std::size_t offset) {
  const std::string_view rest = cursor_.rest();
  std::size_t end = 1;
  while (end < rest.size() && rest[end] != '"' && rest[end] != '\n')
    end += rest[end] == '\\' && end + 1 < rest.size() && rest[end + 1] != '\n' ? 2 : 1;
  const bool is_closed = end < rest.size() && rest[end] == '"';
  cursor_.skip(is_closed ? end + 1 : end);
  return {is_closed ? TokenKind::String : TokenKind::Broken, rest.substr(1, end - 1), offset};
}

std::string described(const Token& token) {
  if (token.kind == TokenKind::End) return "the end of the file";
  if (token.kind == TokenKind::Broken) return "a quote that is not closed on its line";
  return text::quoted(token.text);
}

std::string unescaped(std::string_view text) {
  std::string plain;
  plain.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_escape = text[i] == '\\' && i + 1 < text.size();
    plain += is_escape ? escaped_character(text[++i]) : text[i];
  }
  return plain;
}

}  // namespace candela::pbrt
