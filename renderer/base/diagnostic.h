// What went wrong and where: the sentences that users read.
// Libraries never print, exit or abort; they collect diagnostics and hand them back.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace candela {

// A place in a text file. Lines and columns count from 1; 0 means "not known".
struct SourceSpan {
  std::shared_ptr<const std::string> file;  // as the user would name it; may be null
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

enum class Severity : std::uint8_t { Note, Warning, Error };

struct Diagnostic {
  Severity severity = Severity::Error;
  SourceSpan span;
  std::string message;  // one sentence: what was found, what was expected, did you mean
  std::string excerpt;  // the line's text with a caret below it, or empty
};

// "file:line:column: error: message", then the excerpt on lines of its own where there is one.
[[nodiscard]] std::string to_string(const Diagnostic& diagnostic);

// A reader's collection. After `limit` errors further ones are only counted, so that a broken file
// of a million lines gives a page and not a book. Warnings have a limit of their own. Readers of
// text stop at `most_counted` errors.
class Diagnostics {
 public:
  static constexpr std::size_t limit = 20;
  static constexpr std::size_t most_counted = 1000;

  void add(Diagnostic diagnostic);
  // Unless the same is told of the same place: where several things have one place.
  void add_once(Diagnostic diagnostic);
  void error(SourceSpan span, std::string message);
  void warning(SourceSpan span, std::string message);
  void note(SourceSpan span, std::string message);

  [[nodiscard]] bool has_errors() const { return error_count_ > 0; }
  [[nodiscard]] std::size_t error_count() const { return error_count_; }
  [[nodiscard]] std::size_t warning_count() const { return warning_count_; }
  // True once there are so many errors that a reader may stop.
  [[nodiscard]] bool is_full() const { return error_count_ >= most_counted; }
  // The kept ones, in the order of arrival.
  [[nodiscard]] const std::vector<Diagnostic>& list() const { return list_; }
  // Appends everything of `other`.
  void append(const Diagnostics& other);

 private:
  std::vector<Diagnostic> list_;
  std::size_t error_count_ = 0;
  std::size_t warning_count_ = 0;
};

// The candidate nearest to `word` by edit distance (letter case is free), or "" where none is near
// enough to be worth suggesting.
[[nodiscard]] std::string_view nearest_name(std::string_view word,
                                            const std::vector<std::string_view>& candidates);

// ", did you mean 'X'?" or "".
[[nodiscard]] std::string did_you_mean(std::string_view word,
                                       const std::vector<std::string_view>& candidates);
// The same of a few, all of which are named where none is near: ", expected A, B or C".
[[nodiscard]] std::string nearest_or_all(std::string_view word,
                                         const std::vector<std::string_view>& candidates);

}  // namespace candela
