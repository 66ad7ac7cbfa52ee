#include "scene_io/pbrt/report.h"

#include <algorithm>

namespace candela::pbrt {
namespace {

constexpr std::size_t longest_counted = 4096;

// Files of old Macs end their lines by '\r' alone.
std::string with_newlines(std::string bytes) {
  const bool is_of_old_macs = std::find(bytes.begin(), bytes.end(), '\n') == bytes.end();
  if (is_of_old_macs) std::replace(bytes.begin(), bytes.end(), '\r', '\n');
  return bytes;
}

}  // namespace

SourceFile::SourceFile(const std::string& path, std::string bytes)
    : bytes_(with_newlines(std::move(bytes))),
      source_(text::make_source(path, bytes_)),
      lines_(bytes_) {}

SourceSpan SourceFile::span(std::size_t offset) const {
  const std::size_t index = lines_.line_of(offset);
  const std::string_view line = source_.text.substr(lines_[index], offset - lines_[index]);
  const auto number = static_cast<std::uint32_t>(index + 1);
  // Far into a line bytes are counted: whole scenes stand on one.
  if (line.size() > longest_counted)
    return {source_.name, number, static_cast<std::uint32_t>(line.size() + 1)};
  return {source_.name, number, text::span_at({source_.name, line}, line.size()).column};
}

bool Report::has_said(const Diagnostic& diagnostic) const {
  const auto& said = diagnostics_.list();
  return std::any_of(said.begin(), said.end(), [&](const Diagnostic& other) {
    return other.span.file == diagnostic.span.file && other.span.line == diagnostic.span.line &&
           other.span.column == diagnostic.span.column && other.message == diagnostic.message;
  });
}

void Report::append(const Diagnostics& others) const {
  const auto& list = others.list();
  if (!std::all_of(list.begin(), list.end(), [&](const auto& other) { return has_said(other); }))
    diagnostics_.append(others);
}

void Report::add(Severity severity, const Place& place, std::string message) const {
  if (!place.file) {
    diagnostics_.add({severity, {}, std::move(message), {}});
  } else if (!text::is_kept(diagnostics_, severity)) {
    diagnostics_.add({severity, {}, {}, {}});  // counted only
  } else {
    Diagnostic diagnostic{severity, place.span(), std::move(message),
                          text::excerpt_at(place.file->source(), place.offset)};
    if (!has_said(diagnostic)) diagnostics_.add(std::move(diagnostic));
  }
}

}  // namespace candela::pbrt
