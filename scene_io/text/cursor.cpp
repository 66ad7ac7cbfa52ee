#include "scene_io/text/cursor.h"

#include <cstring>

namespace candela::text {
namespace {

bool ends_in_comment(std::string_view line) {
  const std::string_view said = trimmed(line);
  return said.starts_with('#') || without_comment(said).size() != said.size();
}

// Whether the '\n' at `end` of the line from `begin` is behind a back-slash.
bool is_continued(const char* begin, const char* end) {
  if (end != begin && end[-1] == '\r') --end;
  return end != begin && end[-1] == '\\';
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view without_comment(std::string_view name) {
  const auto is_blank_at = [&](std::size_t i) {
    return i >= name.size() || name[i] == ' ' || name[i] == '\t';  // or an end of the name
  };
  for (std::size_t i = name.find('#'); i != std::string_view::npos; i = name.find('#', i + 1))
    if (is_blank_at(i - 1) && is_blank_at(i + 1)) return trimmed(name.substr(0, i));
  return name;
}

std::string_view Cursor::next_logical_line() {
  const char* const begin = at_;
  const char* part = begin;
  while (true) {
    const auto* newline = static_cast<const char*>(
        part == end_ ? nullptr : std::memchr(part, '\n', static_cast<std::size_t>(end_ - part)));
    if (newline == nullptr) {
      at_ = end_;
      return {begin, static_cast<std::size_t>(end_ - begin)};
    }
    if (!is_continued(part, newline) ||
        ends_in_comment({part, static_cast<std::size_t>(newline - part)})) {
      at_ = newline + 1;
      return {begin, static_cast<std::size_t>(newline - begin)};
    }
    part = newline + 1;
  }
}

}  // namespace candela::text
