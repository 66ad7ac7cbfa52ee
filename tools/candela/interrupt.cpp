#include "tools/candela/interrupt.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>

#include <unistd.h>

#include "renderer/image/temporary_file.h"
#include "tools/candela/exit_code.h"

namespace candela::cli {
namespace {

struct State {
  CancelFlag cancel{false};
  std::atomic<int> signals{0};
  std::atomic<InterruptMode> mode{InterruptMode::EndAtOnce};
};
static_assert(CancelFlag::is_always_lock_free && std::atomic<int>::is_always_lock_free &&
              std::atomic<InterruptMode>::is_always_lock_free);

State state;

void say(const char* text) {
  static_cast<void>(!::write(STDERR_FILENO, text, std::strlen(text)));
}

[[noreturn]] void end_at_once() {
  remove_temporary_file();
  ::_exit(static_cast<int>(ExitCode::Interrupted));
}

void on_signal(int) {
  const int saved_errno = errno;
  const int earlier = state.signals.fetch_add(1);
  if (earlier > 0) {
    say("\nerror: interrupted twice; ended at once\n");
    end_at_once();
  }
  if (state.mode.load() == InterruptMode::EndAtOnce) {
    say("\nerror: interrupted; nothing was written\n");
    end_at_once();
  }
  state.cancel.store(true);
  errno = saved_errno;
}

void handle(int signal) {
  struct sigaction before {};
  if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  ::sigemptyset(&action.sa_mask);
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

void install_signal_handlers() {
  handle(SIGINT);
  handle(SIGTERM);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void set_interrupt_mode(InterruptMode mode) {
  state.mode.store(mode);
}

CancelFlag& cancel_flag() {
  return state.cancel;
}

bool was_interrupted() {
  return state.signals.load() > 0;
}

}  // namespace candela::cli
