// Scene + accelerator -> film. The fourth of the five doors.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "integrators/path_plan.h"
#include "integrators/sampling_strategy.h"
#include "renderer/accel/any_accel.h"
#include "renderer/base/progress.h"
#include "renderer/film/error_estimate.h"
#include "renderer/film/film.h"
#include "renderer/film/filter.h"
#include "renderer/sampling/mis.h"
#include "renderer/scene/compile.h"
#include "renderer/scene/scene.h"

namespace candela {

enum class IntegratorKind : std::uint8_t { Path, Whitted, Raster, Report };

// lab3's own shading: nothing random, samples on a grid.
[[nodiscard]] constexpr bool is_lab_shading(IntegratorKind integrator) {
  return integrator == IntegratorKind::Whitted || integrator == IntegratorKind::Raster;
}

// How whitted and raster shade highlights: by the half vector or by the mirrored direction.
enum class SpecularModel : std::uint8_t { Blinn, Phong };

// How the samples of a pixel know of each other: as points of which a path's pairs go together; of
// which each pair is shuffled by itself; not at all. The last two are for comparisons.
enum class SamplerKind : std::uint8_t { Sobol, Padded, Independent };

// Whether paths follow what others learned of the light: where a trial says that it pays, or
// always.
enum class Guiding : std::uint8_t { Off, Auto, On };

inline constexpr int max_lamp_rays = 64;
inline constexpr int max_side = description::RenderDefaults::largest_side;  // of a picture
inline constexpr int max_samples_per_pixel = description::RenderDefaults::most_samples;

// What costs a sample less and changes nothing that is expected of it; false is for comparisons.
struct PathSavings {
  bool skips_background = true;  // pixels that see nothing for sure (background_pixels.h)
  bool shares_blocks = true;     // pixels whose own samples leave lanes empty (shared_block.h)
  bool has_convoys = true;       // blocks travel together (convoy.h)
  bool opacity_grids = true;     // compile() heeds it; report has them, too
};

struct RenderOptions {
  IntegratorKind integrator = IntegratorKind::Path;
  int width = 512;
  int height = 512;
  // When to stop: the first that is met. Whether it is tells what is done after whole rounds
  // (rounds.h); the time limit may leave some pixels a pass of up to sixteen samples short, or
  // without any where it does not suffice for one.
  int samples_per_pixel = 64;  // whitted and raster: a square number, else the grid has gaps
  std::optional<double> target_relmse;  // to be safely below (render_rounds.cpp); needs replicates
  std::optional<double> time_limit_seconds;
  // Independently randomised sequences a pixel, whose spread states the error; at most
  // samples_per_pixel are used. 1: none is stated. whitted and raster have no error to state.
  int replicates = 4;
  // path: a pilot decides which pixels get how many of the samples; those above are then means over
  // its pixels. Needs enough samples (pilot.h).
  bool adaptive = false;
  PathPlan plan;  // path; scenes with media are not split
  // path by Mis and Power, without splitting or guiding: walks decide on the plan's roulette
  // (roulette/choose_roulette.h).
  bool chooses_roulette = false;
  // path: a trial decides whether the plan's pixels share what their paths find, where they can
  // (reuse/choose_reuse.h).
  bool chooses_reuse = false;
  // path: camera rays a sample that look for lamps alone in pixels that lamps cover in part, at
  // most (path/find_lamp_pixels.h); 0: none.
  int lamp_rays = 0;
  // path by Mis and Power, scenes without media (guiding/choose_guide.h).
  Guiding guiding = Guiding::Off;
  // path: bounces as pbrt counts them: 0 sees emission only, 1 direct light, ...; none: no limit.
  // whitted: surfaces that a ray may meet, as the lab counts them; none: 5.
  std::optional<int> max_depth;
  // path: any. report: Light (its own, which Mis stands for, too), Cosine or Uniform directions.
  SamplingStrategy sampling = SamplingStrategy::Mis;
  Heuristic heuristic = Heuristic::Power;    // of Mis
  SamplerKind sampler = SamplerKind::Sobol;  // path
  // path: light samples for a constant environment, which BSDF samples find as well; strategies
  // that count no light that paths meet have them anyway.
  bool samples_constant_sky = false;
  // path by Mis: light samples leave to BSDF samples what these find as well of an environment
  // (sky_distribution.h); compile() heeds it.
  bool compensates_sky = true;
  // path: lights are picked by what they may send to where they are asked for (light_cells.h);
  // compile() heeds it.
  bool light_cells = true;
  LightSampling light_sampling = LightSampling::Area;  // path; compile() heeds it
  SpecularModel specular = SpecularModel::Blinn;
  // whitted and raster: normals as the lab's code interpolates them, neither made unit nor turned
  // to the viewer; for comparisons with its pictures.
  bool lab_normals = false;
  std::uint64_t seed = 0;
  std::size_t camera = 0;
  std::optional<PixelRect> crop;  // none: everything
  FilterKind filter = FilterKind::BlackmanHarris;
  std::optional<float> filter_radius;
  AovSet aovs = 0;
  bool transparent = false;         // camera rays that leave the scene are black with alpha 0
  bool use_general_kernel = false;  // whatever the scene's features are
  PathSavings savings;              // path
  int tile_size = 16;
  float report_p_rr = 0.8f;  // Report: the probability P_RR to go on, in (0, 1]
  // The film shows daylight of so many kelvins as white (math/white_balance.h); none: no balance.
  std::optional<double> white_balance_kelvins;
  // Samples are dimmed to this in their largest channel. Biased: takes light away.
  float clamp = std::numeric_limits<float>::infinity();
};

// By another rule than the number of samples.
[[nodiscard]] constexpr bool may_end_early(const RenderOptions& options) {
  return options.target_relmse || options.time_limit_seconds;
}

struct RayCounts {
  std::uint64_t camera = 0;
  std::uint64_t indirect = 0;
  std::uint64_t shadow = 0;
  std::uint64_t lamp = 0;     // more camera rays, which look for lamps alone
  std::uint64_t segment = 0;  // between first hits and what other pixels' paths met
};

// What was not done because it could not matter.
struct SkippedCounts {
  std::uint64_t shadow_rays = 0;  // the unoccluded contribution was zero
  std::uint64_t samples = 0;      // of pixels that see nothing but the background, for sure
};

struct InvalidSample {
  int x = 0;
  int y = 0;
  std::uint32_t sample = 0;
};

enum class StopReason : std::uint8_t { Samples, Error, Time, Cancelled };

// What came of RenderOptions::guiding.
struct GuidingDone {
  std::uint64_t training_samples = 0;
  std::size_t cells = 0;         // of space; 0: the picture's paths were not guided
  std::size_t guided_cells = 0;  // of them
};

struct RenderStatistics {
  RayCounts rays;
  SkippedCounts skipped;
  std::uint64_t invalid_samples = 0;
  std::optional<InvalidSample> first_invalid;
  std::string kernel;  // the instance that ran
  PathPlan plan;       // the options', but for what is never split, what walks and trials decided
  std::uint64_t roulette_samples = 0;  // that those took
  std::uint64_t reuse_samples = 0;     // that the trial of shared paths took
  GuidingDone guiding;
  StopReason stop = StopReason::Samples;
};

struct RenderResult {
  Film film;
  RenderStatistics statistics;
  // None where some pixel has no two replicates, or where no sample has met light though the scene
  // has some.
  std::optional<ErrorEstimate> error;
};

// Runs on the current arena's threads (base/parallel.h: with_threads). `progress` and `cancel` may
// be null. When `cancel` becomes true the running tiles end and the film so far is returned.
// Throws std::invalid_argument for options that check_options() (check_options.h) refuses.
[[nodiscard]] RenderResult render(const Scene& scene, const AnyAccelerator& accelerator,
                                  const RenderOptions& options, ProgressSink* progress,
                                  const CancelFlag* cancel);

// Of the film: those that have a sample, and for whitted and raster, which draw nothing at
// random, 1.
[[nodiscard]] std::uint32_t film_replicates(const RenderOptions& options);

// What the radiance of samples is multiplied by where it enters a film.
[[nodiscard]] std::optional<Mat3d> film_balance(const RenderOptions& options);

// What compile() must do for a render with these options.
[[nodiscard]] CompileOptions compile_options(const RenderOptions& options);

// What the options' integrator and strategy cannot draw of a scene: errors that a caller should
// heed, since render() leaves such lights and surfaces black.
[[nodiscard]] Diagnostics check_integrator(const description::SceneDescription& scene,
                                           const RenderOptions& options);

// The name of the kernel that render() would run with Embree.
[[nodiscard]] std::string kernel_name(const Scene& scene, const RenderOptions& options);

// CPU seconds of rendering a fixed share of the tiles, against replaying their rays through bare
// backend calls (`--ray-limit`). For the path integrator only. Nothing where `cancel` (may be null)
// becomes true before the end.
struct RayLimit {
  double render_seconds = 0;
  double rays_seconds = 0;
  std::uint64_t rays = 0;
  [[nodiscard]] double ratio() const {
    return rays_seconds > 0 ? render_seconds / rays_seconds : 0;
  }
};
[[nodiscard]] std::optional<RayLimit> measure_ray_limit(const Scene& scene,
                                                        const AnyAccelerator& accelerator,
                                                        const RenderOptions& options,
                                                        const CancelFlag* cancel);

}  // namespace candela
