// How much of the time that a picture may take is gone.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>

namespace candela {

// Of the time, at most for what comes before the first sample, and for looking closer at pixels
// after the last.
inline constexpr double preparation_share = 0.1;
inline constexpr double look_share = 1.0 / 32;

class TimeBudget {
 public:
  using Clock = std::chrono::steady_clock;

  // None: no limit.
  TimeBudget(std::optional<double> limit_seconds, Clock::time_point start)
      : limit_seconds_(limit_seconds), start_(start) {}

  [[nodiscard]] bool is_spent(double share = 1) const {
    return limit_seconds_ && seconds() >= share * *limit_seconds_;
  }
  // From now on samples are taken.
  void begin_samples(Clock::time_point now = Clock::now()) { seconds_before_ = seconds(now); }
  // How many samples a pixel fit in all into a share of it, at the rate so far; 0 where what comes
  // before them took longer.
  [[nodiscard]] double samples_in_time(std::uint32_t done, double share = 1) const {
    if (!limit_seconds_ || done == 0) return std::numeric_limits<double>::infinity();
    const double left = std::max(share * *limit_seconds_ - seconds_before_, 0.0);
    return done * left / (seconds() - seconds_before_);
  }

 private:
  [[nodiscard]] double seconds(Clock::time_point now = Clock::now()) const {
    const std::chrono::duration<double> elapsed = now - start_;
    return elapsed.count();
  }

  std::optional<double> limit_seconds_;
  Clock::time_point start_;
  double seconds_before_ = 0;
};

}  // namespace candela
