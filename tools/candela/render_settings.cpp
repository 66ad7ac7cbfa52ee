#include "tools/candela/render_settings.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include <fmt/format.h>

#include "scene_io/text/file.h"
#include "tools/candela/memory_need.h"
#include "tools/candela/option_values.h"
#include "tools/candela/refusal.h"

namespace candela::cli {
namespace {

template <class T>
T scene_choice(std::string_view kind, const std::string& word, std::span<const Choice<T>> choices) {
  const Result<T> value = choose(kind, word, choices);
  if (!value)
    throw Refusal{"what the scene asks for: " + value.diagnostics.list()[0].message,
                  ExitCode::Scene};
  return *value;
}

int scaled_side(int side, double scale) {
  const double scaled = std::round(side * scale);
  if (scaled > max_side)
    throw Refusal{fmt::format("--scale {} makes a side of {:.0f} pixels, the most is {}", scale,
                              scaled, max_side),
                  ExitCode::Usage};
  return std::max(1, static_cast<int>(scaled));
}

void settle_size(const RenderArguments& arguments, const description::RenderDefaults& defaults,
                 RenderOptions& options) {
  options.width = defaults.width.value_or(options.width);
  options.height = defaults.height.value_or(options.height);
  if (arguments.size) options.width = arguments.size->width;
  if (arguments.size) options.height = arguments.size->height;
  if (std::min(options.width, options.height) < 1 ||
      std::max(options.width, options.height) > max_side)
    throw Refusal{fmt::format("the scene asks for a picture of {}x{}; sides are 1 to {}",
                              options.width, options.height, max_side),
                  ExitCode::Scene};
  options.width = scaled_side(options.width, arguments.scale);
  options.height = scaled_side(options.height, arguments.scale);
}

// The pixels of a scene's crop window: from the first whose upper left corner is within to the
// last.
PixelRect pixels_of(const description::CropWindow& window, int width, int height) {
  const auto pixel = [](double share, int side) {
    constexpr double rounding = 1e-6;  // of shares that files write with seven digits
    return static_cast<int>(std::ceil(std::clamp(share, 0.0, 1.0) * side - rounding));
  };
  return {pixel(window.left, width), pixel(window.top, height), pixel(window.right, width),
          pixel(window.bottom, height)};
}

void settle_crop(const RenderArguments& arguments, const description::RenderDefaults& defaults,
                 RenderOptions& options) {
  options.crop = arguments.crop;
  if (!options.crop && defaults.crop) {
    options.crop = pixels_of(*defaults.crop, options.width, options.height);
    if (options.crop->is_empty())
      throw Refusal{fmt::format("the scene's crop window holds no pixel of a picture of {}x{}",
                                options.width, options.height),
                    ExitCode::Scene};
  }
  if (!options.crop) return;
  if (options.crop->x1 > options.width || options.crop->y1 > options.height)
    throw Refusal{fmt::format("--crop {},{},{},{} leaves the picture, which is {}x{}",
                              options.crop->x0, options.crop->y0, options.crop->x1,
                              options.crop->y1, options.width, options.height),
                  ExitCode::Usage};
}

int square_side_below(int samples) {
  return static_cast<int>(std::sqrt(static_cast<double>(samples)));
}

// Samples of a grid of n x n: what is asked for, or the next below where it is the scene that asks.
void settle_grid(bool is_said, RenderOptions& options, std::vector<std::string>& warnings) {
  const int asked = options.samples_per_pixel;
  const int side = square_side_below(asked);
  if (side * side == asked) return;
  if (is_said)
    throw Refusal{
        fmt::format("--spp {}: {} puts samples on a grid of n x n; the nearest square "
                    "numbers are {} and {}",
                    asked, integrator_name(options), side * side, (side + 1) * (side + 1)),
        ExitCode::Usage};
  options.samples_per_pixel = side * side;
  warnings.push_back(
      fmt::format("the scene asks for {} samples a pixel, {} takes {}: a grid of "
                  "{} x {}",
                  asked, integrator_name(options), side * side, side, side));
}

void settle_stop_rules(const RenderArguments& arguments, RenderOptions& options) {
  options.replicates = arguments.replicates.value_or(options.replicates);
  if (arguments.error_goal) options.target_relmse = *arguments.error_goal * *arguments.error_goal;
  if (arguments.relmse_goal)
    options.target_relmse =
        std::min(*arguments.relmse_goal, options.target_relmse.value_or(*arguments.relmse_goal));
  options.time_limit_seconds = arguments.time_limit_seconds;
}

// How many samples go where, and which paths they are.
void settle_paths(const RenderArguments& arguments, RenderOptions& options) {
  options.adaptive = arguments.adaptive.value_or(options.adaptive && options.replicates > 1);
  options.plan.splitting = static_cast<std::uint32_t>(arguments.splitting.value_or(1));
  if (arguments.reuses_paths) {
    options.chooses_reuse = !arguments.reuses_paths->is_on;
    options.plan.reuses_paths = arguments.reuses_paths->is_on.value_or(false);
  }
  if (arguments.roulette) {
    options.chooses_roulette = !arguments.roulette->threshold;
    options.plan.roulette_threshold =
        static_cast<float>(arguments.roulette->threshold.value_or(default_roulette_threshold));
  }
  options.guiding = arguments.guiding.value_or(options.guiding);
  options.sampler = arguments.sampler.value_or(options.sampler);
  options.lamp_rays = arguments.lamp_rays.value_or(options.lamp_rays);
  options.report_p_rr = static_cast<float>(arguments.report_p_rr.value_or(options.report_p_rr));
  if (arguments.clamp) options.clamp = static_cast<float>(*arguments.clamp);
}

void settle_light(const RenderArguments& arguments, RenderOptions& options) {
  options.sampling = arguments.sampling.value_or(options.sampling);
  options.heuristic = arguments.heuristic.value_or(options.heuristic);
  options.samples_constant_sky =
      arguments.samples_constant_sky.value_or(options.samples_constant_sky);
  options.compensates_sky = arguments.compensates_sky.value_or(options.compensates_sky);
  options.light_sampling = arguments.light_sampling.value_or(options.light_sampling);
  options.light_cells = arguments.light_cells.value_or(options.light_cells);
}

void settle_samples(const RenderArguments& arguments, const description::RenderDefaults& defaults,
                    RenderOptions& options, std::vector<std::string>& warnings) {
  if (may_end_early(options) && !arguments.samples_per_pixel) {
    options.samples_per_pixel = max_samples_per_pixel;
    return;
  }
  options.samples_per_pixel = arguments.samples_per_pixel.value_or(
      defaults.samples_per_pixel.value_or(options.samples_per_pixel));
  if (options.samples_per_pixel < 1 || options.samples_per_pixel > max_samples_per_pixel)
    throw Refusal{fmt::format("the scene asks for {} samples a pixel; expected 1 to {}",
                              options.samples_per_pixel, max_samples_per_pixel),
                  ExitCode::Scene};
  if (is_lab_shading(options.integrator))
    settle_grid(arguments.samples_per_pixel.has_value(), options, warnings);
}

IntegratorKind integrator_of(const RenderArguments& arguments,
                             const description::RenderDefaults& defaults) {
  if (arguments.integrator) return *arguments.integrator;
  if (!defaults.integrator) return IntegratorKind::Path;
  return scene_choice("integrator", *defaults.integrator, integrator_choices());
}

// How samples become pixels.
void settle_film(const RenderArguments& arguments, const description::RenderDefaults& defaults,
                 RenderOptions& options) {
  options.aovs = arguments.aovs;
  options.transparent = arguments.is_transparent;
  options.white_balance_kelvins = defaults.white_balance_kelvins;
  if (is_lab_shading(options.integrator)) {
    options.filter = FilterKind::Box;
    return;
  }
  if (arguments.filter)
    options.filter = *arguments.filter;
  else if (defaults.filter)
    options.filter = scene_choice("filter", *defaults.filter, filter_choices());
  if (defaults.filter_radius && !arguments.filter)
    options.filter_radius =
        std::max(static_cast<float>(*defaults.filter_radius), std::numeric_limits<float>::min());
}

void settle_depth(const RenderArguments& arguments, const description::RenderDefaults& defaults,
                  RenderOptions& options) {
  options.max_depth = arguments.max_depth ? arguments.max_depth->depth : defaults.max_depth;
  if (options.integrator == IntegratorKind::Whitted) {
    if (arguments.max_depth && !arguments.max_depth->depth)
      throw Refusal{"--max-depth none: whitted needs a limit, such as 5", ExitCode::Usage};
    options.max_depth = options.max_depth.value_or(default_whitted_depth);
  }
  if (options.integrator == IntegratorKind::Raster) {
    if (arguments.max_depth)
      throw Refusal{"--max-depth: raster follows no ray beyond the first surface", ExitCode::Usage};
    options.max_depth.reset();
  }
}

void settle_camera(const RenderArguments& arguments,
                   const description::SceneDescription& description, RenderOptions& options) {
  options.camera = arguments.camera;
  const std::size_t count = description.cameras.size();
  if (options.camera == 0 || options.camera < count) return;
  throw Refusal{fmt::format("--camera {}: the scene has {}", options.camera,
                            count == 0   ? "none of its own"
                            : count == 1 ? "only camera 0"
                                         : fmt::format("cameras 0 to {}", count - 1)),
                ExitCode::Usage};
}

RenderSettings settled(const RenderArguments& arguments,
                       const description::SceneDescription& description, MemoryNeed need) {
  const description::RenderDefaults& defaults = description.defaults;
  RenderSettings settings;
  RenderOptions& options = settings.options;
  options = usual_options(integrator_of(arguments, defaults));
  settle_size(arguments, defaults, options);
  settle_crop(arguments, defaults, options);
  settle_film(arguments, defaults, options);
  settle_stop_rules(arguments, options);
  settle_paths(arguments, options);
  settle_light(arguments, options);
  options.seed = arguments.seed.value_or(defaults.seed.value_or(options.seed));
  options.lab_normals = arguments.has_lab_normals;
  options.specular = arguments.specular.value_or(options.specular);
  options.uses_general_kernel = arguments.uses_general_kernel;
  options.savings = path_savings_without(arguments.without);
  refuse_what_does_not_fit(arguments, options);
  settle_samples(arguments, defaults, options, settings.warnings);
  settle_depth(arguments, defaults, options);
  settle_camera(arguments, description, options);
  if (need == MemoryNeed::Heeded)
    if (const std::optional<std::string> sentence = missing_memory(options))
      throw Refusal{*sentence, ExitCode::Limit};
  settings.display = {arguments.tone_map,
                      arguments.exposure.value_or(defaults.exposure.value_or(0))};
  return settings;
}

}  // namespace

SettledSettings settle_settings(const RenderArguments& arguments,
                                const description::SceneDescription& description, MemoryNeed need) {
  try {
    return {settled(arguments, description, need), "", ExitCode::Done};
  } catch (const Refusal& refusal) {
    return {{}, refusal.sentence, refusal.exit_code};
  }
}

std::vector<std::string> output_paths(const RenderArguments& arguments) {
  if (!arguments.outputs.empty()) return arguments.outputs;
  std::filesystem::path scene = arguments.scene.path;
  if (text::has_gzip_name(arguments.scene.path)) scene = scene.stem();
  return {scene.stem().string() + ".exr"};
}

}  // namespace candela::cli
