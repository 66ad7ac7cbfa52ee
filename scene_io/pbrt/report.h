// Places in the files of a pbrt scene, and what is said about them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "renderer/base/diagnostic.h"
#include "scene_io/text/line_begins.h"
#include "scene_io/text/source.h"

namespace candela::pbrt {

// One file's text, which stays where it is as long as the scene is being read.
class SourceFile {
 public:
  SourceFile(const std::string& path, std::string bytes);
  SourceFile(const SourceFile&) = delete;
  SourceFile& operator=(const SourceFile&) = delete;

  [[nodiscard]] const text::Source& source() const { return source_; }
  [[nodiscard]] const std::string& path() const { return *source_.name; }
  // Line and column of a byte, by a table.
  [[nodiscard]] SourceSpan span(std::size_t offset) const;

 private:
  std::string bytes_;
  text::Source source_;
  text::LineBegins lines_;
};

struct Place {
  const SourceFile* file = nullptr;
  std::size_t offset = 0;

  [[nodiscard]] SourceSpan span() const { return file ? file->span(offset) : SourceSpan{}; }
};

// Collects what is wrong, with the line's text and a caret. What files say that are included twice
// is said once. One a thread.
class Report {
 public:
  explicit Report(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  void error(const Place& place, std::string message) const {
    ++error_count_;
    add(Severity::Error, place, std::move(message));
  }
  void warning(const Place& place, std::string message) const {
    add(Severity::Warning, place, std::move(message));
  }
  void note(const Place& place, std::string message) const {
    add(Severity::Note, place, std::move(message));
  }
  // What another thread collected of one statement.
  void append(const Diagnostics& others) const;
  // False: further warnings are only counted, so their sentences need not be made.
  [[nodiscard]] bool wants_warnings() const {
    return text::is_kept(diagnostics_, Severity::Warning);
  }
  // did_you_mean() of the keys of a map; "" where further errors are only counted.
  template <class Map>
  [[nodiscard]] std::string did_you_mean_key(std::string_view word, const Map& map) const {
    if (!text::is_kept(diagnostics_, Severity::Error)) return "";
    std::vector<std::string_view> keys;
    for (const auto& entry : map) keys.push_back(entry.first);
    return did_you_mean(word, keys);
  }
  // Those that were said before are counted again.
  [[nodiscard]] std::size_t error_count() const { return error_count_; }
  [[nodiscard]] bool is_full() const { return diagnostics_.is_full(); }
  [[nodiscard]] Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  [[nodiscard]] bool has_said(const Diagnostic& diagnostic) const;
  void add(Severity severity, const Place& place, std::string message) const;

  Diagnostics& diagnostics_;
  mutable std::size_t error_count_ = 0;
};

}  // namespace candela::pbrt
