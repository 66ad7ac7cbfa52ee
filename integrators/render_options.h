// What a render is asked for. Pixels count from the upper left corner.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "integrators/path_plan.h"
#include "integrators/sampling_strategy.h"
#include "renderer/film/film.h"
#include "renderer/film/filter.h"
#include "renderer/sampling/mis.h"
#include "renderer/scene/compile.h"

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

inline constexpr int default_whitted_depth = 5;
inline constexpr int max_replicates = 1024;
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
  // most (path/find_lamp_pixels.h); 0 and 1: none.
  int lamp_rays = 0;
  // path by Mis and Power, scenes without media (guiding/choose_guide.h).
  Guiding guiding = Guiding::Off;
  // path: bounces as pbrt counts them: 0 sees emission only, 1 direct light, ...; none: no limit.
  // whitted: surfaces that a ray may meet, as the lab counts them; none: the default.
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
  bool transparent = false;          // camera rays that leave the scene are black with alpha 0
  bool uses_general_kernel = false;  // whatever the scene's features are
  PathSavings savings;               // path
  int tile_size = 16;
  float report_p_rr = 0.8f;  // Report: the probability P_RR to go on, in (0, 1]
  // The film shows daylight of so many kelvins as white (math/white_balance.h); none: no balance.
  std::optional<double> white_balance_kelvins;
  // Samples are dimmed to this in their largest channel. Biased: takes light away.
  float clamp = std::numeric_limits<float>::infinity();
};

// With all that makes pictures better in the mean, as `candela render` has it; 16 samples for
// whitted and raster.
[[nodiscard]] RenderOptions usual_options(IntegratorKind integrator = IntegratorKind::Path);

// By another rule than the number of samples.
[[nodiscard]] constexpr bool may_end_early(const RenderOptions& options) {
  return options.target_relmse || options.time_limit_seconds;
}

[[nodiscard]] inline PixelRect rendered_rect(const RenderOptions& options) {
  return options.crop.value_or(PixelRect{0, 0, options.width, options.height});
}

[[nodiscard]] inline Filter make_filter(const RenderOptions& options) {
  return {options.filter, options.filter_radius.value_or(default_radius(options.filter))};
}

// Of the film: those that have a sample, and for whitted and raster, which draw nothing at
// random, 1.
[[nodiscard]] std::uint32_t film_replicates(const RenderOptions& options);

// What the radiance of samples is multiplied by where it enters a film.
[[nodiscard]] std::optional<Mat3d> film_balance(const RenderOptions& options);

// What compile() must do for a render with these options.
[[nodiscard]] CompileOptions compile_options(const RenderOptions& options);

}  // namespace candela
