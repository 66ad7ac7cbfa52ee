#include "scene_io/lab3/reader.h"

#include <algorithm>

namespace candela::lab3 {
namespace {

bool begins_a_character(char c) {
  return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u;  // not a continuation byte of UTF-8
}

}  // namespace

Reader::Reader(const std::string& path, std::string_view text, const LoadOptions& load_options,
               description::SceneDescription& target, Diagnostics& found)
    : options(load_options),
      scene(target),
      diagnostics(found),
      source(text::make_source(path, text)) {
  line_begins_.push_back(0);
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') line_begins_.push_back(i + 1);
}

SourceSpan Reader::span(std::size_t offset) const {
  const std::size_t place = std::min(offset, source.text.size());
  const auto next = std::upper_bound(line_begins_.begin(), line_begins_.end(), place);
  const std::size_t line = static_cast<std::size_t>(next - line_begins_.begin());
  const std::string_view before =
      source.text.substr(line_begins_[line - 1], place - line_begins_[line - 1]);
  const auto column = std::count_if(before.begin(), before.end(), begins_a_character);
  return {source.name, static_cast<std::uint32_t>(line), static_cast<std::uint32_t>(column + 1)};
}

void Reader::add(Severity severity, std::size_t offset, std::string message) {
  if (!text::is_kept(diagnostics, severity)) {
    diagnostics.add({severity, {}, {}, {}});  // only counted
    return;
  }
  // Aliases may stand for one node many times.
  diagnostics.add_once(
      {severity, span(offset), std::move(message), text::excerpt_at(source, offset)});
}

void Reader::error(std::size_t offset, std::string message) {
  add(Severity::Error, offset, std::move(message));
}

void Reader::warning(std::size_t offset, std::string message) {
  add(Severity::Warning, offset, std::move(message));
}

void Reader::note(std::string message) {
  diagnostics.note({source.name, 0, 0}, std::move(message));
}

}  // namespace candela::lab3
