// How much of the time that a picture may take is gone.
#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>

namespace candela {

class TimeBudget {
 public:
  using Clock = std::chrono::steady_clock;

  // None: no limit.
  TimeBudget(std::optional<double> limit_seconds, Clock::time_point start)
      : limit_seconds_(limit_seconds), start_(start) {}

  [[nodiscard]] bool is_spent(double share = 1) const {
    return limit_seconds_ && seconds() >= share * *limit_seconds_;
  }
  // How many samples a pixel fit into it in all, at the rate so far.
  [[nodiscard]] double samples_in_time(std::uint32_t done) const {
    if (!limit_seconds_ || done == 0) return std::numeric_limits<double>::infinity();
    return done * *limit_seconds_ / seconds();
  }

 private:
  [[nodiscard]] double seconds() const {
    const std::chrono::duration<double> elapsed = Clock::now() - start_;
    return elapsed.count();
  }

  std::optional<double> limit_seconds_;
  Clock::time_point start_;
};

}  // namespace candela
