#include "scene_io/text/plain_text.h"

namespace candela::text {

bool is_utf16(std::string_view text) {
  return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
}

std::string_view without_byte_order_mark(std::string_view text) {
  return text.starts_with("\xef\xbb\xbf") ? text.substr(3) : text;
}

void drop_byte_order_mark(std::string& text) {
  text.erase(0, text.size() - without_byte_order_mark(text).size());
}

void use_line_feeds(std::string& text) {
  const std::size_t first = text.find_first_of("\r\n");
  if (first == std::string::npos || text[first] == '\n' || text.substr(first, 2) == "\r\n") return;
  for (std::size_t i = first; i < text.size(); ++i)
    if (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n')) text[i] = '\n';
}

}  // namespace candela::text
