// A text in memory and places in it, for every reader of text formats.
// Places are byte offsets while reading; lines and columns are found only when something is said
// about one, so that nothing is counted on the fast path.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "renderer/base/diagnostic.h"

namespace candela::text {

// A named text that outlives what reads it.
struct Source {
  std::shared_ptr<const std::string> name;  // as users see it
  std::string_view text;
};

[[nodiscard]] Source make_source(const std::string& name, std::string_view text);

// Line and column (characters of UTF-8, from 1) of a byte of the text.
[[nodiscard]] SourceSpan span_at(const Source& source, std::size_t offset);

// The line around `offset` with a caret below that byte: at most 100 characters of it, control
// characters and bytes that are no UTF-8 as blanks, so that it is safe on a terminal.
[[nodiscard]] std::string excerpt_at(const Source& source, std::size_t offset);

// A diagnostic with span and excerpt.
[[nodiscard]] Diagnostic diagnose(const Source& source, std::size_t offset, Severity severity,
                                  std::string message);

// Adds it to the diagnostics; where those of its severity would not be kept any more, it is only
// counted and costs nothing. (Finding a line takes time in proportion to the text.)
void report(Diagnostics& diagnostics, const Source& source, std::size_t offset, Severity severity,
            std::string message);

// Whether one more of this severity is worth composing: errors and warnings that would be kept, and
// notes while there are few messages of all kinds (Diagnostics keeps all notes).
[[nodiscard]] bool is_kept(const Diagnostics& diagnostics, Severity severity);

// Spans of many places of one text, cheap where each lies behind the one before.
class SpanFinder {
 public:
  explicit SpanFinder(Source source) : source_(std::move(source)) {}
  [[nodiscard]] SourceSpan operator()(std::size_t offset);

 private:
  Source source_;
  std::size_t line_begin_ = 0;
  std::uint32_t line_ = 1;
};

// `word` in quotes, shortened to 40 characters, control characters and bytes that are no UTF-8 as
// '?'.
[[nodiscard]] std::string quoted(std::string_view word);
// A path in quotes, whole: its end tells most.
[[nodiscard]] std::string quoted_path(std::string_view path);

}  // namespace candela::text
