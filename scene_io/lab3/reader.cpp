#include "scene_io/lab3/reader.h"

#include <algorithm>

#include "renderer/base/printable.h"

namespace candela::lab3 {

Reader::Reader(const std::string& path, std::string_view text, const LoadOptions& load_options,
               description::SceneDescription& target, Diagnostics& found)
    : options(load_options),
      scene(target),
      diagnostics(found),
      source(text::make_source(path, text)),
      lines_(text) {}

SourceSpan Reader::span(std::size_t offset) const {
  const std::size_t place = std::min(offset, source.text.size());
  const std::size_t line = lines_.line_of(place);
  const std::string_view before = source.text.substr(lines_[line], place - lines_[line]);
  const auto column = std::ranges::count_if(before, std::not_fn(is_utf8_continuation));
  return {source.name, static_cast<std::uint32_t>(line + 1),
          static_cast<std::uint32_t>(column + 1)};
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
