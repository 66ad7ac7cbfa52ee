#include "tools/candela/console.h"

#include <cstring>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "renderer/base/counted.h"
#include "renderer/base/file_descriptor.h"
#include "renderer/base/printable.h"

namespace candela::cli {
namespace {

constexpr std::string_view erase_line = "\r\x1b[K";

}  // namespace

Console::Console(bool is_quiet, int file_descriptor)
    : file_descriptor_(file_descriptor),
      is_quiet_(is_quiet),
      is_terminal_(::isatty(file_descriptor) == 1) {}

void Console::print_line(std::string_view line) {
  const std::scoped_lock lock(mutex_);
  std::string text;
  if (!live_line_.empty()) text += erase_line;
  text += line;
  text += '\n';
  text += live_line_;
  static_cast<void>(write_all(file_descriptor_, text));
}

void Console::note(std::string_view line) {
  if (!is_quiet_) print_line(printable(line));
}

void Console::warning(std::string_view sentence) {
  print_line(fmt::format("warning: {}", printable(sentence)));
}

void Console::error(std::string_view sentence) {
  print_line(fmt::format("error: {}", printable(sentence)));
}

void Console::strict_error(std::size_t warnings, std::string_view scene) {
  error(fmt::format("--strict: {} about '{}'", counted(warnings, "warning"), scene));
}

void Console::print(const Diagnostics& diagnostics) {
  std::size_t errors = 0;
  std::size_t warnings = 0;
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    if (diagnostic.severity == Severity::Error) ++errors;
    if (diagnostic.severity == Severity::Warning) ++warnings;
    if (diagnostic.severity == Severity::Note && is_quiet_) continue;
    print_line(to_string(diagnostic));
  }
  if (diagnostics.warning_count() > warnings)
    warning(fmt::format("{} further warnings", diagnostics.warning_count() - warnings));
  if (diagnostics.error_count() > errors)
    error(fmt::format("{} further errors", diagnostics.error_count() - errors));
}

void Console::set_live_line(std::string line) {
  const std::scoped_lock lock(mutex_);
  if (!is_terminal_ || (live_line_.empty() && line.empty())) return;
  live_line_ = std::move(line);
  static_cast<void>(write_all(file_descriptor_, std::string(erase_line) + live_line_));
}

std::size_t Console::columns() const {
  winsize size{};
  if (::ioctl(file_descriptor_, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return size.ws_col;
}

ExitCode print_result(const std::string& text, Console& console) {
  const int reason = write_all(STDOUT_FILENO, text);
  if (reason == 0) return ExitCode::Done;
  if (reason != EPIPE)
    console.error(fmt::format("the result cannot be written: {}", std::strerror(reason)));
  return ExitCode::Output;
}

}  // namespace candela::cli
