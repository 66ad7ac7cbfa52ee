#include "integrators/render_rounds.h"

#include "integrators/closer_look.h"
#include "integrators/guiding/choose_guide.h"
#include "integrators/path/reuse_groups.h"
#include "integrators/pilot.h"
#include "integrators/reuse/choose_reuse.h"
#include "integrators/roulette/choose_roulette.h"
#include "integrators/rounds.h"
#include "renderer/base/parallel.h"
#include "renderer/film/tiles.h"

namespace candela {
namespace {

// What decides whether to stop: half the way to the upper end of the interval of what is stated, so
// that a picture seldom ends since its error is understated just then.
double deciding_relmse(const ErrorEstimate& error) {
  return (error.relmse + error.interval95.high) / 2;
}

class Loop {
 public:
  Loop(const RenderOptions& options, const TileFunction& render_tile, Film& film,
       ProgressSink* progress, const CancelFlag* cancel, bool has_light,
       TimeBudget::Clock::time_point start)
      : options_(options),
        render_tile_(render_tile),
        film_(film),
        progress_(progress),
        cancel_(cancel),
        has_light_(has_light),
        budget_(options.time_limit_seconds, start),
        share_of_passes_(film.replicates() > 1 ? 1 - look_share : 1),
        tiles_(tiles_of(film.crop(), options.tile_size)),
        pilot_(pilot_of(options)),
        has_no_time_to_prepare_(
            [this] { return is_set(cancel_) || budget_.is_spent(preparation_share); }),
        look_(options, render_tile, [this] { return is_set(cancel_) || budget_.is_spent(); }) {}

  RoundsDone run() {
    RoundsDone result;
    const auto most = static_cast<std::uint32_t>(options_.samples_per_pixel);
    std::optional<StopReason> stop;
    expect({});
    choose_plan(result);
    if (options_.integrator == IntegratorKind::Path)
      guide_ = choose_guide(options_, render_tile_, has_no_time_to_prepare_);
    result.guiding = guiding_done();
    budget_.begin_samples();
    while (!stop) {
      if (pilot_.samples > 0 && done_ == 0)
        stop = render_pilot();
      else
        stop = render_round(round_end(done_, film_.replicates(), most, goal(result.error)),
                            result.error);
      if (!stop && done_ == most) stop = StopReason::Samples;
      if (stop || options_.target_relmse || progress_)
        result.error = state_error(stop || options_.target_relmse);
      if (reaches_goal(result.error) && stop != StopReason::Cancelled) stop = StopReason::Error;
      error_samples_ = done_;
      if (progress_ && result.error) progress_->state_error(stated_error(*result.error));
      expect(result.error);
    }
    result.stop = *stop;
    result.counts = counts_;
    return result;
  }

 private:
  void choose_plan(RoundsDone& result) {
    const RouletteChoice roulette =
        choose_roulette(options_, render_tile_, has_no_time_to_prepare_);
    plan_ = roulette.plan;
    const ReuseChoice reuse = choose_reuse(options_, plan_, render_tile_, has_no_time_to_prepare_);
    plan_.reuses_paths = reuse.reuses_paths;
    result.plan = plan_;
    result.roulette_samples = roulette.samples;
    result.reuse_samples = reuse.samples;
  }

  [[nodiscard]] GuidingDone guiding_done() const {
    if (!guide_.field) return {guide_.training_samples};
    return {guide_.training_samples, guide_.field->cells(), guide_.field->guided_cells()};
  }

  // Into the film itself where that has all pixels and sums of the pilot.
  std::optional<StopReason> render_pilot() {
    if (pilot_.fits(film_.crop(), film_.replicates())) return render_pilot(film_);
    Film pilot(options_.width, options_.height, pilot_.rect, film_.aovs(), pilot_.sums,
               film_balance(options_));
    if (pilot_.sums != film_.replicates()) pilot.sum_pieces_of(pilot_.samples / pilot_.sums);
    const auto stop = render_pilot(pilot);
    film_.take_part_of(pilot);
    return stop;
  }
  std::optional<StopReason> render_pilot(Film& pilot) {
    const auto stop = render_passes(pilot_.samples, {}, [&](const SampleRange& range) {
      render_pass(tiles_of(pilot_.rect, options_.tile_size), pass_of(range), pilot);
    });
    if (!stop) density_.emplace(pilot, plan_.reuses_paths ? reuse_square : 1);
    return stop;
  }

  // `is_sure`: with what the picture alone does not know.
  [[nodiscard]] std::optional<ErrorEstimate> state_error(bool is_sure) {
    std::optional<PixelErrors> errors = estimate_pixel_errors(film_);
    if (!errors) return {};
    if (errors->is_black() && has_light_) {
      if (progress_ != nullptr) progress_->miss_light();
      return {};
    }
    if (is_sure) counts_.invalid_samples += look_.correct(film_, pass_of({}), *errors);
    ErrorEstimate estimate =
        estimate_error(film_, *errors, plan_.reuses_paths ? int{reuse_group_size} : 1);
    estimate.looked_at = look_.pixels();
    estimate.look_samples = look_.samples();
    return estimate;
  }

  // Why it did not come to its end, if it did not.
  std::optional<StopReason> render_round(std::uint32_t end,
                                         const std::optional<ErrorEstimate>& error) {
    return render_passes(end, error, [&](const SampleRange& range) {
      TilePass pass = pass_of(range);
      if (density_) pass.deal_out_by(*density_);
      render_pass(tiles_, pass, film_);
    });
  }

  [[nodiscard]] TilePass pass_of(const SampleRange& range) const {
    return {{}, range, nullptr, options_.seed, plan_, guide_.field.get(), nullptr};
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
        const double fitting = caution * budget_.samples_in_time(done_, share_of_passes_);
        if (fitting < pass.first + 1) return StopReason::Time;
        if (fitting < pass.end) pass.end = static_cast<std::uint32_t>(fitting);
      }
      render(pass);
      if (is_set(cancel_)) return StopReason::Cancelled;
      done_ = pass.end;
      expect(error);
      if (budget_.is_spent(share_of_passes_)) return StopReason::Time;
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
      if (is_set(cancel_) || budget_.is_spent(share_of_passes_)) return;
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
    double samples = std::min<double>(options_.samples_per_pixel,
                                      budget_.samples_in_time(done_, share_of_passes_));
    if (error && options_.target_relmse)
      samples = std::min(samples, samples_for(*goal(error), error_samples_));
    progress_->expect(static_cast<std::uint64_t>(
        samples * static_cast<double>(film_.pixel_count()) + samples_beside()));
  }

  // Of the pilot, which are none of the picture's.
  [[nodiscard]] double samples_beside() const {
    if (pilot_.samples == 0) return 0;
    const double pixels = static_cast<double>(pilot_.rect.width()) * pilot_.rect.height();
    return pilot_.samples * (pixels - static_cast<double>(film_.pixel_count()));
  }

  const RenderOptions& options_;
  const TileFunction& render_tile_;
  Film& film_;
  ProgressSink* progress_;
  const CancelFlag* cancel_;
  bool has_light_;
  TimeBudget budget_;
  double share_of_passes_;  // of the time
  std::vector<PixelRect> tiles_;
  Pilot pilot_;
  std::optional<SampleDensity> density_;  // once the pilot is there
  TileCounts counts_;
  std::function<bool()> has_no_time_to_prepare_;
  CloserLook look_;
  PathPlan plan_;
  GuideChoice guide_;
  std::uint32_t done_ = 0;
  std::uint32_t error_samples_ = 0;  // a pixel, when the error was estimated
};

}  // namespace

RoundsDone render_rounds(const RenderOptions& options, const TileFunction& render_tile, Film& film,
                         ProgressSink* progress, const CancelFlag* cancel, bool has_light,
                         TimeBudget::Clock::time_point start) {
  return Loop(options, render_tile, film, progress, cancel, has_light, start).run();
}

}  // namespace candela
