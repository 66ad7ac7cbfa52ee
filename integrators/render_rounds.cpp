#include "integrators/render_rounds.h"

#include <chrono>

#include "integrators/choose_path_plan.h"
#include "integrators/guiding/choose_guide.h"
#include "integrators/rounds.h"
#include "renderer/base/parallel.h"
#include "renderer/film/tiles.h"
#include "renderer/sampling/hash.h"

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

// Samples a pixel of the pilot; 0: there is none. Four a replicate are the fewest that tell noise
// from structure, and they should not be most of the picture.
std::uint32_t pilot_samples(const RenderOptions& options, const Film& film) {
  const std::uint32_t replicates = film.replicates();
  const std::uint32_t samples =
      std::max((whole_block + replicates - 1) / replicates, 4u) * replicates;
  const bool is_worth_it = static_cast<std::uint32_t>(options.samples_per_pixel) >= 8 * samples;
  return options.adaptive && replicates > 1 && is_worth_it ? samples : 0;
}

// Of the pilot in each pixel, where `all` samples a pixel are there with it. Fixed beforehand:
// weights that a pixel's own samples decide would be biased. By counts, as if the samples that the
// pilot deals out were worth this many of its own.
double pilot_weight(double pilot_samples, double all) {
  constexpr double worth = 1.5;
  return pilot_samples / (pilot_samples + worth * (all - pilot_samples));
}

// What is known before the rest of the samples is dealt out.
struct Pilot {
  Film film;  // of the whole picture, whatever the crop
  SampleDensity density;
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
        pilot_samples_(pilot_samples(options, film)) {}

  RoundsDone run() {
    RoundsDone result;
    const auto most = static_cast<std::uint32_t>(options_.samples_per_pixel);
    std::optional<StopReason> stop;
    expect({});
    if (options_.integrator == IntegratorKind::Path) plan_paths();
    result.plan = plan_;
    result.guiding = guiding_done();
    while (!stop) {
      if (pilot_samples_ > 0 && !pilot_)
        stop = render_pilot();
      else
        stop = render_round(round_end(done_, film_.replicates(), most, goal(result.error)),
                            result.error);
      if (!stop && done_ == most) stop = StopReason::Samples;
      if (stop || options_.target_relmse || progress_) result.error = error_so_far();
      if (reaches_goal(result.error) && stop != StopReason::Cancelled) stop = StopReason::Error;
      error_samples_ = done_;
      if (progress_ && result.error) progress_->state_error(result.error->rmse);
      expect(result.error);
    }
    if (pilot_) film_ = with_pilot();
    result.stop = *stop;
    result.counts = counts_;
    return result;
  }

 private:
  void plan_paths() {
    plan_ = choose_path_plan(options_, render_tile_, cancel_);
    guide_ = choose_guide(options_, render_tile_, plan_, cancel_);
  }
  [[nodiscard]] GuidingDone guiding_done() const {
    if (!guide_.field) return {guide_.training_samples};
    return {guide_.training_samples, guide_.field->cells(), guide_.field->guided_cells()};
  }

  // The first samples of all pixels, from random numbers of their own.
  std::optional<StopReason> render_pilot() {
    const PixelRect whole{0, 0, options_.width, options_.height};
    Film film(options_.width, options_.height, whole, film_.aovs(), film_.replicates(),
              film_balance(options_));
    const auto stop = render_passes(pilot_samples_, {}, [&](const SampleRange& range) {
      render_pass(tiles_of(whole, options_.tile_size), pass_of(range), film);
    });
    pilot_.emplace(Pilot{std::move(film), {}});
    if (!stop) pilot_->density = SampleDensity(pilot_->film);
    return stop;
  }

  // Why it did not come to its end, if it did not.
  std::optional<StopReason> render_round(std::uint32_t end,
                                         const std::optional<ErrorEstimate>& error) {
    return render_passes(end, error, [&](const SampleRange& range) {
      TilePass pass = pass_of(range);
      if (pilot_) {
        pass.range = {range.first - pilot_samples_, range.end - pilot_samples_};
        pass.density = &pilot_->density;
        pass.seed = mix_bits(options_.seed + 1);
      }
      render_pass(tiles_, pass, film_);
    });
  }

  [[nodiscard]] TilePass pass_of(const SampleRange& range) const {
    return {{}, range, nullptr, options_.seed, plan_, guide_.field.get(), nullptr};
  }

  // The picture so far, where there is a pilot.
  [[nodiscard]] Film with_pilot() const {
    return film_.with_pilot(pilot_->film, pilot_weight(pilot_samples_, done_));
  }
  [[nodiscard]] std::optional<ErrorEstimate> error_so_far() const {
    return pilot_ ? estimate_error(with_pilot()) : estimate_error(film_);
  }

  // `render`: what renders a range of samples a pixel.
  template <class Render>
  std::optional<StopReason> render_passes(std::uint32_t end,
                                          const std::optional<ErrorEstimate>& error,
                                          const Render& render) {
    while (done_ < end) {
      SampleRange pass = next_pass(done_, end, is_long());
      if (done_ > 0) {
        constexpr double caution = 0.95;  // the next pass may be slower
        const double fitting = caution * budget_.samples_in_time(done_);
        if (fitting < pass.first + 1) return StopReason::Time;
        if (fitting < pass.end) pass.end = static_cast<std::uint32_t>(fitting);
      }
      render(pass);
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

  void render_pass(const std::vector<PixelRect>& tiles, const TilePass& pass, Film& film) {
    std::vector<TileCounts> counts(tiles.size());
    parallel_for(tiles.size(), [&](std::size_t i) {
      if (is_set(cancel_) || budget_.is_spent()) return;
      TilePass own = pass;
      own.tile = tiles[i];
      counts[i] = render_tile_(own, film);
      if (progress_ != nullptr)
        progress_->advance(static_cast<std::uint64_t>(own.tile.width()) *
                           static_cast<std::uint64_t>(own.tile.height()) *
                           (pass.range.end - pass.range.first));
    });
    for (const TileCounts& tile : counts) counts_.add(tile);
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
  std::uint32_t pilot_samples_;
  std::optional<Pilot> pilot_;
  TileCounts counts_;
  PathPlan plan_;
  GuideChoice guide_;
  std::uint32_t done_ = 0;
  std::uint32_t error_samples_ = 0;  // a pixel, when the error was estimated
};

}  // namespace

RoundsDone render_rounds(const RenderOptions& options, const TileFunction& render_tile, Film& film,
                         ProgressSink* progress, const CancelFlag* cancel) {
  return Loop(options, render_tile, film, progress, cancel).run();
}

}  // namespace candela
