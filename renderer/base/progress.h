// How a long call tells how far it is, and how it is asked to stop.
#pragma once

#include <atomic>
#include <cstdint>

namespace candela {

// Set from a signal handler or another thread; polled between units of work.
using CancelFlag = std::atomic<bool>;

// Called from worker threads: implementations must be thread-safe and quick.
class ProgressSink {
 public:
  virtual ~ProgressSink() = default;
  // `samples` more camera samples are done, of a total announced by the caller.
  virtual void advance(std::uint64_t samples) = 0;
};

}  // namespace candela
