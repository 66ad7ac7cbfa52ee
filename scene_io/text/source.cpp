#include "scene_io/text/source.h"

#include <algorithm>
#include <cstdint>

#include "renderer/base/printable.h"
#include "scene_io/text/cursor.h"

namespace candela::text {
namespace {

constexpr std::size_t excerpt_width = 100;
constexpr std::size_t quote_width = 40;

std::uint32_t count_characters(std::string_view text) {
  const auto continuations = std::count_if(text.begin(), text.end(), is_utf8_continuation);
  return static_cast<std::uint32_t>(text.size() - static_cast<std::size_t>(continuations));
}

std::size_t line_begin(std::string_view text, std::size_t offset) {
  const std::size_t newline = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
  return newline == std::string_view::npos ? 0 : newline + 1;
}

// Moves a cut off the middle of a character.
std::size_t character_begin(std::string_view text, std::size_t offset) {
  for (int step = 0; step < 3 && offset > 0 && offset < text.size(); ++step) {
    if (!is_utf8_continuation(text[offset])) break;
    --offset;
  }
  return offset;
}

}  // namespace

Source make_source(const std::string& name, std::string_view text) {
  return {std::make_shared<const std::string>(name), text};
}

SourceSpan SpanFinder::operator()(std::size_t offset) {
  offset = std::min(offset, source_.text.size());
  if (offset < line_begin_) {
    line_begin_ = 0;
    line_ = 1;
  }
  for (std::size_t newline = source_.text.find('\n', line_begin_); newline < offset;
       newline = source_.text.find('\n', line_begin_)) {
    line_begin_ = newline + 1;
    ++line_;
  }
  const std::string_view before = source_.text.substr(line_begin_, offset - line_begin_);
  return {source_.name, line_, count_characters(before) + 1};
}

SourceSpan span_at(const Source& source, std::size_t offset) {
  return SpanFinder(source)(offset);
}

std::string excerpt_at(const Source& source, std::size_t offset) {
  const std::string_view text = source.text;
  offset = std::min(offset, text.size());
  std::size_t begin = line_begin(text, offset);
  if (offset - begin > excerpt_width * 3 / 4) {
    begin = character_begin(text, offset - excerpt_width / 2);
  }
  std::size_t end = std::min(text.find('\n', offset), text.size());
  end = character_begin(text, std::min(end, begin + excerpt_width));
  std::string line = printable(text.substr(begin, end - begin), ' ');
  line.erase(line.find_last_not_of(' ') + 1);
  const std::string before = printable(text.substr(begin, offset - begin), ' ');
  return line + '\n' + std::string(count_characters(before), ' ') + '^';
}

Diagnostic diagnose(const Source& source, std::size_t offset, Severity severity,
                    std::string message) {
  return {severity, span_at(source, offset), std::move(message), excerpt_at(source, offset)};
}

bool is_kept(const Diagnostics& diagnostics, Severity severity) {
  switch (severity) {
    case Severity::Note:
      return diagnostics.list().size() < 4 * Diagnostics::limit;
    case Severity::Warning:
      return diagnostics.warning_count() < Diagnostics::limit;
    case Severity::Error:
      return diagnostics.error_count() < Diagnostics::limit;
  }
  return true;
}

void report(Diagnostics& diagnostics, const Source& source, std::size_t offset, Severity severity,
            std::string message) {
  if (is_kept(diagnostics, severity)) {
    diagnostics.add(diagnose(source, offset, severity, std::move(message)));
  } else if (severity != Severity::Note) {
    diagnostics.add({severity, {}, {}, {}});  // counted only
  }
}

std::string quoted(std::string_view word) {
  const bool is_long = word.size() > quote_width;
  const std::size_t end = is_long ? character_begin(word, quote_width) : word.size();
  return '\'' + printable(word.substr(0, end), '?') + (is_long ? "...'" : "'");
}

std::string quoted_path(std::string_view path) {
  return '\'' + printable(path, '?') + '\'';
}

}  // namespace candela::text
