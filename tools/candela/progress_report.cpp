#include "tools/candela/progress_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace candela::cli {
namespace {

constexpr std::size_t max_bar_cells = 40;
constexpr double highest_fraction = 0.999;  // until the files are on disk

double fraction_of(const ProgressState& state) {
  if (state.total == 0) return 0;
  return static_cast<double>(state.done) / static_cast<double>(state.total);
}

std::string seconds_left_text(const ProgressState& state) {
  const double fraction = fraction_of(state);
  if (fraction <= 0) return "?";
  return duration_text(std::max(0.0, state.elapsed_seconds * (1 / fraction - 1)));
}

// Or all before the point.
std::string two_digits(double number) {
  return number < 99.5 ? fmt::format("{:.2g}", number) : fmt::format("{:.0f}", number);
}

}  // namespace

std::string percent_text(const ProgressState& state) {
  const double shown = std::min(fraction_of(state), highest_fraction);
  return fmt::format("{:.1f} %", std::floor(shown * 1000) / 10);
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::llround(std::clamp(seconds, 0.0, 3.6e9)));
  const std::int64_t hours = whole / 3600;
  const std::int64_t minutes = whole / 60 % 60;
  if (hours > 0) return fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60);
  return fmt::format("{}:{:02}", minutes, whole % 60);
}

std::string error_text(double rmse) {
  return two_digits(100 * rmse) + " %";
}

std::string error_text(const StatedError& error) {
  return fmt::format("{} ({} to {})", error_text(error.rmse), two_digits(100 * error.low),
                     two_digits(100 * error.high));
}

std::string progress_line(const ProgressState& state) {
  const double rate =
      state.elapsed_seconds > 0 ? static_cast<double>(state.done) / state.elapsed_seconds : 0;
  const std::string error = state.error          ? ", error " + error_text(*state.error)
                            : state.misses_light ? ", no light met yet"
                                                 : "";
  return fmt::format("{}, {} elapsed, {} left, {:.2f} Msamples/s{}", percent_text(state),
                     duration_text(state.elapsed_seconds), seconds_left_text(state), rate * 1e-6,
                     error);
}

std::string progress_bar(const ProgressState& state, std::size_t columns) {
  const std::string line = progress_line(state);
  constexpr std::size_t frame = 4;  // brackets, a blank, and the last column, which may wrap
  if (columns <= line.size() + frame) return line.substr(0, columns > 0 ? columns - 1 : 0);
  const std::size_t cells = std::min(columns - line.size() - frame, max_bar_cells);
  const double fraction = std::min(fraction_of(state), highest_fraction);
  const auto filled = static_cast<std::size_t>(fraction * static_cast<double>(cells));
  return fmt::format("[{}{}] {}", std::string(filled, '#'), std::string(cells - filled, '.'), line);
}

ProgressReport::ProgressReport(Console& console, Interval interval)
    : console_(console),
      interval_(interval.count() > 0    ? interval
                : console.is_terminal() ? bar_interval
                                        : line_interval) {
  if (!console.is_quiet()) thread_ = std::jthread([this](std::stop_token stop) { run(stop); });
}

ProgressReport::~ProgressReport() {
  stop();
}

void ProgressReport::stop() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
  console_.set_live_line("");
}

void ProgressReport::state_error(const StatedError& error) {
  const std::lock_guard lock(error_mutex_);
  error_ = error;
}

ProgressState ProgressReport::state() const {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  const std::lock_guard lock(error_mutex_);
  return {done_.load(std::memory_order_relaxed), total_.load(std::memory_order_relaxed),
          elapsed.count(), error_, misses_light_.load(std::memory_order_relaxed)};
}

void ProgressReport::run(std::stop_token stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    wake_.wait_for(lock, stop, interval_, [] { return false; });
    if (!stop.stop_requested()) report();
  }
}

void ProgressReport::report() {
  if (console_.is_terminal())
    console_.set_live_line(progress_bar(state(), console_.columns()));
  else
    console_.note(progress_line(state()));
}

}  // namespace candela::cli
