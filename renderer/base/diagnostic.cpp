#include "renderer/base/diagnostic.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "renderer/base/letter_case.h"
#include "renderer/base/one_of.h"
#include "renderer/base/printable.h"

namespace candela {
namespace {

std::string_view word_of(Severity severity) {
  switch (severity) {
    case Severity::Note:
      return "note";
    case Severity::Warning:
      return "warning";
    case Severity::Error:
      return "error";
  }
  return "";
}

std::string place_of(const SourceSpan& span) {
  if (!span.file) return "";
  const std::string file = printable(*span.file);
  if (span.line == 0) return fmt::format("{}: ", file);
  if (span.column == 0) return fmt::format("{}:{}: ", file, span.line);
  return fmt::format("{}:{}:{}: ", file, span.line, span.column);
}

bool is_same_place(const SourceSpan& a, const SourceSpan& b) {
  if (a.line != b.line || a.column != b.column) return false;
  return a.file == b.file || (a.file && b.file && *a.file == *b.file);
}

// Levenshtein's distance, where two neighbours that changed places are one edit as well
// [Damerau64], each place edited once. Three rows at a time.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  std::vector<std::size_t> above(b.size() + 1);
  std::vector<std::size_t> next(b.size() + 1);
  const auto is_same = [&](std::size_t i, std::size_t j) {
    return to_lower(a[i]) == to_lower(b[j]);
  };
  for (std::size_t i = 0; i < a.size(); ++i) {
    next[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      next[j + 1] = std::min({row[j] + (is_same(i, j) ? 0 : 1), row[j + 1] + 1, next[j] + 1});
      if (i > 0 && j > 0 && is_same(i, j - 1) && is_same(i - 1, j))
        next[j + 1] = std::min(next[j + 1], above[j - 1] + 1);
    }
    above.swap(row);
    row.swap(next);
  }
  return row.back();
}

}  // namespace

std::string to_string(const Diagnostic& diagnostic) {
  std::string text = fmt::format("{}{}: {}", place_of(diagnostic.span),
                                 word_of(diagnostic.severity), diagnostic.message);
  if (!diagnostic.excerpt.empty()) text += '\n' + diagnostic.excerpt;
  return text;
}

void Diagnostics::add(Diagnostic diagnostic) {
  diagnostic.message = printable(diagnostic.message);  // names in scenes may hold anything
  const bool is_error = diagnostic.severity == Severity::Error;
  const bool is_warning = diagnostic.severity == Severity::Warning;
  const std::size_t earlier = is_error ? error_count_ : is_warning ? warning_count_ : 0;
  if (is_error) ++error_count_;
  if (is_warning) ++warning_count_;
  if (earlier < limit) list_.push_back(std::move(diagnostic));
}

void Diagnostics::add_once(Diagnostic diagnostic) {
  diagnostic.message = printable(diagnostic.message);
  const bool is_told = std::any_of(list_.begin(), list_.end(), [&](const Diagnostic& told) {
    return told.severity == diagnostic.severity && told.message == diagnostic.message &&
           is_same_place(told.span, diagnostic.span);
  });
  if (!is_told) add(std::move(diagnostic));
}

void Diagnostics::error(SourceSpan span, std::string message) {
  add({Severity::Error, std::move(span), std::move(message), {}});
}

void Diagnostics::warning(SourceSpan span, std::string message) {
  add({Severity::Warning, std::move(span), std::move(message), {}});
}

void Diagnostics::note(SourceSpan span, std::string message) {
  add({Severity::Note, std::move(span), std::move(message), {}});
}

void Diagnostics::append(const Diagnostics& other) {
  const std::size_t errors = error_count_ + other.error_count_;
  const std::size_t warnings = warning_count_ + other.warning_count_;
  for (const Diagnostic& diagnostic : other.list_) add(diagnostic);
  error_count_ = errors;
  warning_count_ = warnings;
}

// Words are compared by so many of their first bytes.
constexpr std::size_t compared_length = 200;

std::string_view nearest_name(std::string_view word,
                              const std::vector<std::string_view>& candidates) {
  word = word.substr(0, compared_length);
  std::string_view best;
  std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string_view candidate : candidates) {
    const std::size_t length_gap = candidate.size() > word.size() ? candidate.size() - word.size()
                                                                  : word.size() - candidate.size();
    if (length_gap >= best_distance) continue;
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& candidates) {
  const std::string_view name = nearest_name(word, candidates);
  return name.empty() ? "" : fmt::format(", did you mean '{}'?", name);
}

std::string nearest_or_all(std::string_view word, const std::vector<std::string_view>& candidates) {
  const std::string nearest = did_you_mean(word, candidates);
  if (!nearest.empty() || candidates.empty()) return nearest;
  return ", expected " + one_of(candidates);
}

}  // namespace candela
