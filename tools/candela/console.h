// What people read: messages on stderr, results on stdout.
#pragma once

#include <mutex>
#include <string>
#include <string_view>

#include "renderer/base/diagnostic.h"
#include "tools/candela/exit_code.h"

namespace candela::cli {

// Messages, one write a message, around a live line (the progress bar) that is redrawn below them.
// Thread-safe.
class Console {
 public:
  explicit Console(bool is_quiet, int file_descriptor = 2);

  // Not printed when quiet.
  void note(std::string_view line);
  // Warnings and errors of candela itself.
  void warning(std::string_view sentence);
  void error(std::string_view sentence);
  // That --strict makes an error of so many warnings.
  void strict_error(std::size_t warnings, std::string_view scene);
  // All that a reader found; notes only when not quiet.
  void print(const Diagnostics& diagnostics);

  // Replaces the line at the bottom; empty removes it. Terminals only.
  void set_live_line(std::string line);
  // Characters a line; 80 where nobody knows.
  [[nodiscard]] std::size_t columns() const;
  [[nodiscard]] bool is_terminal() const { return is_terminal_; }
  [[nodiscard]] bool is_quiet() const { return is_quiet_; }

 private:
  void print_line(std::string_view line);

  std::mutex mutex_;
  std::string live_line_;
  int file_descriptor_;
  bool is_quiet_;
  bool is_terminal_;
};

// Writes a command's result to stdout. Output where that fails; silently where the reader of a pipe
// has gone away.
[[nodiscard]] ExitCode print_result(const std::string& text, Console& console);

}  // namespace candela::cli
