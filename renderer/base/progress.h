// How a long call tells how far it is, and how it is asked to stop.
#pragma once

#include <atomic>
#include <cstdint>

namespace candela {

// Set from a signal handler or another thread; polled between units of work.
using CancelFlag = std::atomic<bool>;

// `flag` may be null.
[[nodiscard]] inline bool is_set(const CancelFlag* flag) {
  return flag != nullptr && flag->load(std::memory_order_relaxed);
}

// The picture's rMSE as it states it, and its interval of 95 % (renderer/film/error_estimate.h).
struct StatedError {
  double rmse = 0;
  double low = 0;
  double high = 0;
};

// Called from worker threads: implementations must be thread-safe and quick.
class ProgressSink {
 public:
  virtual ~ProgressSink() = default;
  // `samples` more camera samples are done.
  virtual void advance(std::uint64_t samples) = 0;
  // So many will be done in all, as far as can be told now.
  virtual void expect(std::uint64_t total_samples) = 0;
  virtual void state_error(const StatedError& error) = 0;
  // No error can be stated yet: no sample has met light, though the scene has some.
  virtual void miss_light() = 0;
};

}  // namespace candela
