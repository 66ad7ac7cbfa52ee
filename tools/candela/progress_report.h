// How far a render is: a bar on a terminal, a plain line now and then elsewhere.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "renderer/base/progress.h"
#include "tools/candela/console.h"

namespace candela::cli {

struct ProgressState {
  std::uint64_t done = 0;  // camera samples
  std::uint64_t total = 0;
  double elapsed_seconds = 0;
  std::optional<StatedError> error = std::nullopt;  // so far
  bool misses_light = false;                        // and so can state none
};

// "42.3 %", never "100 %": that is said when the files are on disk.
[[nodiscard]] std::string percent_text(const ProgressState& state);
// "1:05", "2:03:04".
[[nodiscard]] std::string duration_text(double seconds);
// "2.1 %".
[[nodiscard]] std::string error_text(double rmse);
// "2.1 % (1.9 to 2.3)".
[[nodiscard]] std::string error_text(const StatedError& error);
// "42.3 %, 0:12 elapsed, 0:17 left, 3.21 Msamples/s, error 2.1 % (1.9 to 2.3)", or "no light met
// yet" in place of the error.
[[nodiscard]] std::string progress_line(const ProgressState& state);
// The same behind a bar that fills the rest of `columns` characters; cut where they do not suffice.
[[nodiscard]] std::string progress_bar(const ProgressState& state, std::size_t columns);

class ProgressReport : public ProgressSink {
 public:
  using Interval = std::chrono::milliseconds;
  static constexpr Interval line_interval{10'000};
  static constexpr Interval bar_interval{125};

  // Reports every `interval`; 0: the one that fits the console.
  explicit ProgressReport(Console& console, Interval interval = Interval{0});
  ~ProgressReport() override;
  ProgressReport(const ProgressReport&) = delete;
  ProgressReport& operator=(const ProgressReport&) = delete;

  void advance(std::uint64_t samples) override {
    done_.fetch_add(samples, std::memory_order_relaxed);
  }
  void expect(std::uint64_t total_samples) override {
    total_.store(total_samples, std::memory_order_relaxed);
  }
  void state_error(const StatedError& error) override;
  void miss_light() override { misses_light_.store(true, std::memory_order_relaxed); }
  // Stops reporting and removes the bar. Called by the destructor too.
  void stop();
  [[nodiscard]] ProgressState state() const;

 private:
  void run(std::stop_token stop);
  void report();

  Console& console_;
  Interval interval_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::atomic<std::uint64_t> done_{0};
  std::atomic<std::uint64_t> total_{0};
  mutable std::mutex error_mutex_;
  std::optional<StatedError> error_;
  std::atomic<bool> misses_light_{false};
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread thread_;  // last: it uses the others
};

}  // namespace candela::cli
