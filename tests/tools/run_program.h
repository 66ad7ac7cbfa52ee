// Runs the built program as users do: another process, its words, its outputs, its exit code.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

namespace candela::cli_test {

struct ProgramResult {
  int exit_code = -1;  // -1: ended by a signal or by the watchdog
  std::string output;  // stdout
  std::string error;   // stderr
};

enum class ErrorStream { File, Terminal };

// One run of a program. Its signals have their default actions, whatever ours are. A run that is
// not over after `watchdog` is killed, which no test may count on.
class Program {
 public:
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)  // ten times as slow
  static constexpr std::chrono::seconds watchdog{1200};
#else
  static constexpr std::chrono::seconds watchdog{120};
#endif

  // `words`: the program's path first.
  Program(const std::vector<std::string>& words, ErrorStream error_stream);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void send(int signal) const;
  // Until stderr holds `text`; false where the program ends or the watchdog barks before.
  [[nodiscard]] bool wait_for_error_text(const std::string& text);
  // Until the program handles SIGINT itself.
  [[nodiscard]] bool wait_for_handler() const;
  [[nodiscard]] ProgramResult finish();

 private:
  void drain_terminal();
  [[nodiscard]] std::string error_so_far();

  pid_t process_ = -1;
  std::string folder_;  // of the files that hold its outputs
  int terminal_ = -1;
  std::string terminal_text_;
};

[[nodiscard]] std::vector<std::string> candela_words(const std::vector<std::string>& arguments);
// candela with these arguments, to its end.
[[nodiscard]] ProgramResult run_candela(const std::vector<std::string>& arguments,
                                        ErrorStream error_stream = ErrorStream::File);

// An empty folder of the test's own, below the build folder.
[[nodiscard]] std::string fresh_folder(const std::string& name);
[[nodiscard]] std::string file_text(const std::string& path);
void write_text(const std::string& path, const std::string& text);
// Sorted, hidden files too.
[[nodiscard]] std::vector<std::string> file_names(const std::string& folder);

// A scene that renders in milliseconds a sample at the sizes that tests use.
[[nodiscard]] std::string small_scene();

}  // namespace candela::cli_test
