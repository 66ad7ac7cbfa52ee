// What all text formats stand on: words, numbers, lines, places; and gzip.
#include <cfloat>
#include <cmath>
#include <cstdlib>

#include "scene_io/text/cursor.h"
#include "scene_io/text/file.h"
#include "scene_io/text/number.h"
#include "scene_io/text/source.h"
#include "tests/fuzz/check_errors.h"
#include "tests/fuzz/readers.h"

namespace candela::fuzz {
namespace {

// A number that is accepted is the one that the C library reads, but for those that are too small.
std::string fault_of_number(std::string_view word) {
  const text::Number<double> number = text::parse_double(word);
  if (!number) return text::describe(number.fault).empty() ? "a fault without words" : "";
  const std::string terminated(word);
  char* end = nullptr;
  const double expected = std::strtod(terminated.c_str(), &end);
  if (end != terminated.c_str() + terminated.size()) return "not a number for strtod";
  const bool is_same =
      number.value == expected || (std::abs(expected) < DBL_MIN && number.value == 0.0);
  return is_same ? "" : "another number than strtod's";
}

std::string fault_of_integer(std::string_view word) {
  const text::Number<std::int64_t> number = text::parse_integer(word);
  if (!number) return "";
  const std::string terminated(word);
  return number.value == std::strtoll(terminated.c_str(), nullptr, 10)
             ? ""
             : "another number than strtoll's";
}

std::string fault_of_words(text::Cursor line) {
  for (std::string_view word = line.next_word(); !word.empty(); word = line.next_word()) {
    if (std::string fault = fault_of_number(word); !fault.empty()) return fault;
    if (std::string fault = fault_of_integer(word); !fault.empty()) return fault;
  }
  return "";
}

std::string fault_of_place(const text::Source& source, std::size_t offset) {
  const SourceSpan span = text::span_at(source, offset);
  if (span.line < 1 || span.column < 1) return "a place before the text";
  std::size_t lines = 0;
  for (const char c : text::excerpt_at(source, offset)) {
    if (c == '\n' && ++lines > 2) return "an excerpt of more than two lines";
    if (static_cast<unsigned char>(c) < 32 && c != '\n') return "an excerpt that a terminal obeys";
  }
  return "";
}

}  // namespace

std::string try_text(std::string_view bytes) {
  const text::Source source = text::make_source("fuzzed", bytes);
  text::Cursor lines(bytes);
  while (!lines.at_end()) {
    const char* const begin = lines.position();
    const std::string_view line = lines.next_logical_line();
    if (lines.position() == begin) return "a line without end";
    if (std::string fault = fault_of_words(text::Cursor(line)); !fault.empty()) return fault;
    const auto offset = static_cast<std::size_t>(begin - bytes.data());
    if (bytes.size() > 4096) continue;  // a place takes time in proportion to the text
    if (std::string fault = fault_of_place(source, offset + line.size() / 2); !fault.empty())
      return fault;
  }
  return "";
}

std::string try_gzip(std::string_view bytes) {
  constexpr std::size_t most = std::size_t{1} << 20;
  const Result<std::string> text = text::inflate_gzip(bytes, "fuzzed.gz", {.inflated_bytes = most});
  if (!text) return fault_of_failure(text.diagnostics);
  return text->size() <= most ? "" : "more than is allowed";
}

}  // namespace candela::fuzz
