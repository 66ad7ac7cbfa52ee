#include "integrators/render_rounds.h"

#include <chrono>

#include "integrators/rounds.h"
#include "renderer/base/parallel.h"
#include "renderer/film/tiles.h"

namespace candela {
namespace {

bool is_set(const CancelFlag* flag) {
  return flag != nullptr && flag->load(std::memory_order_relaxed);
}

// What decides whether to stop: half the way to the upper end of the interval of what is stated, so
// that a picture seldom ends since its error is understated just then.
double deciding_relmse(const ErrorEstimate& error) {
  return (error.relmse + error.interval95.high) / 2;
}

// How many samples a pixel still fit into the time, from how long those so far took.
class TimeBudget {
 public:
  explicit TimeBudget(std::optional<double> limit_seconds) : limit_seconds_(limit_seconds) {}

  [[nodiscard]] bool is_spent() const { return limit_seconds_ && seconds() >= *limit_seconds_; }
  // In all, at the rate so far.
  [[nodiscard]] double samples_in_time(std::uint32_t done) const {
    if (!limit_seconds_ || done == 0) return std::numeric_limits<double>::infinity();
    return done * *limit_seconds_ / seconds();
  }

 private:
  [[nodiscard]] double seconds() const {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    return elapsed.count();
  }

  std::optional<double> limit_seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

class Loop {
 public:
  Loop(const RenderOptions& options, const TileFunction& render_tile, Film& film,
       ProgressSink* progress, const CancelFlag* cancel)
      : options_(options),
        render_tile_(render_tile),
        film_(film),
        progress_(progress),
        cancel_(cancel),
        budget_(options.time_limit_seconds),
        tiles_(tiles_of(film.crop(), options.tile_size)),
        counts_(tiles_.size()) {}

  RoundsDone run() {
    RoundsDone result;
    const auto most = static_cast<std::uint32_t>(options_.samples_per_pixel);
    std::optional<StopReason> stop;
    expect({});
    while (!stop) {
      stop = render_round(round_end(done_, film_.replicates(), most, goal(result.error)),
                          result.error);
      if (!stop && done_ == most) stop = StopReason::Samples;
      if (stop || options_.target_relmse || progress_) result.error = estimate_error(film_);
      if (reaches_goal(result.error) && stop != StopReason::Cancelled) stop = StopReason::Error;
      error_samples_ = done_;
      if (progress_ && result.error) progress_->state_error(result.error->rmse);
      expect(result.error);
    }
    result.stop = *stop;
    for (const TileCounts& tile : counts_) result.counts.add(tile);
    return result;
  }

 private:
  // Why it did not come to its end, if it did not.
  std::optional<StopReason> render_round(std::uint32_t end,
                                         const std::optional<ErrorEstimate>& error) {
    while (done_ < end) {
      SampleRange pass = next_pass(done_, end, is_long());
      if (done_ > 0) {
        constexpr double caution = 0.95;  // the next pass may be slower
        const double fitting = caution * budget_.samples_in_time(done_);
        if (fitting < pass.first + 1) return StopReason::Time;
        if (fitting < pass.end) pass.end = static_cast<std::uint32_t>(fitting);
      }
      render_pass(pass);
      if (is_set(cancel_)) return StopReason::Cancelled;
      done_ = pass.end;
      expect(error);
      if (budget_.is_spent()) return StopReason::Time;
    }
    return {};
  }

  // Where a first block might take more than a few seconds, or too much of the time that there is.
  [[nodiscard]] bool is_long() const {
    constexpr std::uint64_t samples_of_seconds = 1u << 23;
    const std::uint64_t pixels =
        static_cast<std::uint64_t>(options_.width) * static_cast<std::uint64_t>(options_.height);
    return options_.time_limit_seconds || pixels * whole_block > samples_of_seconds;
  }

  void render_pass(const SampleRange& pass) {
    parallel_for(tiles_.size(), [&](std::size_t i) {
      if (is_set(cancel_) || budget_.is_spent()) return;
      const PixelRect& tile = tiles_[i];
      counts_[i].add(render_tile_(tile, pass.first, pass.end, film_));
      if (progress_ != nullptr)
        progress_->advance(static_cast<std::uint64_t>(tile.width()) *
                           static_cast<std::uint64_t>(tile.height()) * (pass.end - pass.first));
    });
  }

  [[nodiscard]] std::optional<ErrorGoal> goal(const std::optional<ErrorEstimate>& error) const {
    if (!options_.target_relmse) return {};
    return ErrorGoal{error ? deciding_relmse(*error) : std::numeric_limits<double>::infinity(),
                     *options_.target_relmse};
  }
  [[nodiscard]] bool reaches_goal(const std::optional<ErrorEstimate>& error) const {
    return options_.target_relmse && error && deciding_relmse(*error) <= *options_.target_relmse;
  }

  // `error`: as of the last round; the rules then tell how many samples there will be.
  void expect(const std::optional<ErrorEstimate>& error) const {
    if (progress_ == nullptr) return;
    double samples = std::min<double>(options_.samples_per_pixel, budget_.samples_in_time(done_));
    if (error && options_.target_relmse)
      samples = std::min(samples, samples_for(*goal(error), error_samples_));
    progress_->expect(
        static_cast<std::uint64_t>(samples * static_cast<double>(film_.pixel_count())));
  }

  const RenderOptions& options_;
  const TileFunction& render_tile_;
  Film& film_;
  ProgressSink* progress_;
  const CancelFlag* cancel_;
  TimeBudget budget_;
  std::vector<PixelRect> tiles_;
  std::vector<TileCounts> counts_;
  std::uint32_t done_ = 0;
  std::uint32_t error_samples_ = 0;  // a pixel, when the error was estimated
};

}  // namespace

RoundsDone render_rounds(const RenderOptions& options, const TileFunction& render_tile, Film& film,
                         ProgressSink* progress, const CancelFlag* cancel) {
  return Loop(options, render_tile, film, progress, cancel).run();
}

}  // namespace candela
