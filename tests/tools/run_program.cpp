#include "tests/tools/run_program.h"

#include <fcntl.h>
#include <pty.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>

extern char** environ;

namespace candela::cli_test {
namespace {

constexpr std::chrono::milliseconds poll_interval{2};

class Attributes {
 public:
  Attributes() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) sigaddset(&signals, signal);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setsigdefault(&attributes_, &signals);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF);
  }
  ~Attributes() { posix_spawnattr_destroy(&attributes_); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;
  [[nodiscard]] const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

class Actions {
 public:
  Actions() {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
  }
  ~Actions() { posix_spawn_file_actions_destroy(&actions_); }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;
  void write_to(int descriptor, const std::string& path) {
    posix_spawn_file_actions_addopen(&actions_, descriptor, path.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0600);
  }
  void duplicate(int from, int to) { posix_spawn_file_actions_adddup2(&actions_, from, to); }
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

// Calls `is_done` now and then until it is true, or the watchdog barks.
template <class Condition>
bool wait_until(Condition is_done) {
  const auto end = std::chrono::steady_clock::now() + Program::watchdog;
  while (!is_done()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(poll_interval);
  }
  return true;
}

bool has_ended(pid_t process) {
  siginfo_t info{};
  return ::waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         info.si_pid == process;
}

std::string own_folder() {
  static std::atomic<int> count{0};
  return fresh_folder(fmt::format("run-{}-{}", ::getpid(), count.fetch_add(1)));
}

}  // namespace

Program::Program(const std::vector<std::string>& words, ErrorStream error_stream)
    : folder_(own_folder()) {
  Actions actions;
  actions.write_to(1, folder_ + "/stdout");
  int terminal_end = -1;
  if (error_stream == ErrorStream::File) {
    actions.write_to(2, folder_ + "/stderr");
  } else {
    if (::openpty(&terminal_, &terminal_end, nullptr, nullptr, nullptr) != 0)
      throw std::runtime_error("no pseudo terminal");
    ::fcntl(terminal_, F_SETFL, O_NONBLOCK);
    ::fcntl(terminal_, F_SETFD, FD_CLOEXEC);
    actions.duplicate(terminal_end, 2);
  }
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  const Attributes attributes;
  const int error =
      ::posix_spawn(&process_, argv[0], actions.get(), attributes.get(), argv.data(), environ);
  if (terminal_end >= 0) ::close(terminal_end);
  if (error != 0) throw std::runtime_error("cannot run " + words[0]);
}

Program::~Program() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  if (terminal_ >= 0) ::close(terminal_);
  std::filesystem::remove_all(folder_);
}

void Program::send(int signal) const {
  ::kill(process_, signal);
}

void Program::drain_terminal() {
  if (terminal_ < 0) return;
  char buffer[4096];
  for (ssize_t count = 0; (count = ::read(terminal_, buffer, sizeof buffer)) > 0;)
    terminal_text_.append(buffer, static_cast<std::size_t>(count));
}

std::string Program::error_so_far() {
  drain_terminal();
  return terminal_ >= 0 ? terminal_text_ : file_text(folder_ + "/stderr");
}

bool Program::wait_for_error_text(const std::string& text) {
  const auto is_there = [&] { return error_so_far().find(text) != std::string::npos; };
  static_cast<void>(wait_until([&] { return is_there() || has_ended(process_); }));
  return is_there();
}

bool Program::wait_for_handler() const {
  const auto is_caught = [&] {
    std::ifstream status(fmt::format("/proc/{}/status", process_));
    for (std::string line; std::getline(status, line);)
      if (line.starts_with("SigCgt:"))
        return ((std::stoull(line.substr(7), nullptr, 16) >> (SIGINT - 1)) & 1) == 1;
    return false;
  };
  static_cast<void>(wait_until([&] { return is_caught() || has_ended(process_); }));
  return is_caught();
}

ProgramResult Program::finish() {
  const bool is_over = wait_until([&] {
    drain_terminal();
    return has_ended(process_);
  });
  if (!is_over) ::kill(process_, SIGKILL);
  int status = 0;
  ::waitpid(process_, &status, 0);
  process_ = -1;
  ProgramResult result;
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  result.output = file_text(folder_ + "/stdout");
  result.error = error_so_far();
  return result;
}

std::vector<std::string> candela_words(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{CANDELA_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

ProgramResult run_candela(const std::vector<std::string>& arguments, ErrorStream error_stream) {
  return Program(candela_words(arguments), error_stream).finish();
}

std::string fresh_folder(const std::string& name) {
  const testing::TestInfo* const test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string own =
      test != nullptr ? fmt::format("{}/{}", test->test_suite_name(), test->name()) : "any";
  const std::string folder = fmt::format("{}/command_line/{}/{}", CANDELA_TEST_OUTPUT, own, name);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

std::string file_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void write_text(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::vector<std::string> file_names(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string small_scene() {
  return CANDELA_SOURCE_DIR "/assets/cornell_box_diffuse/cornell_box_diffuse.yaml";
}

}  // namespace candela::cli_test
