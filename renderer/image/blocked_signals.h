// While this stands, writing past the process's file size limit or into a closed pipe is an error
// of the call and not the end of the process.
#pragma once

#include <csignal>
#include <ctime>
#include <initializer_list>

namespace candela {

// Both signals go to the thread that writes, so holding them back there is enough. What arrived
// meanwhile is taken away at the end, but for a signal that waited already.
class BlockedWriteSignals {
 public:
  BlockedWriteSignals() {
    sigset_t waiting;
    sigemptyset(&mine_);
    sigpending(&waiting);
    for (const int signal : {SIGXFSZ, SIGPIPE})
      if (sigismember(&waiting, signal) == 0) sigaddset(&mine_, signal);
    pthread_sigmask(SIG_BLOCK, &mine_, &earlier_);
  }
  BlockedWriteSignals(const BlockedWriteSignals&) = delete;
  BlockedWriteSignals& operator=(const BlockedWriteSignals&) = delete;
  ~BlockedWriteSignals() {
    const timespec no_time{};
    while (sigtimedwait(&mine_, nullptr, &no_time) > 0) continue;
    pthread_sigmask(SIG_SETMASK, &earlier_, nullptr);
  }

 private:
  sigset_t mine_;
  sigset_t earlier_;
};

}  // namespace candela
