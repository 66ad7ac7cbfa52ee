#include "tools/candela/render_settings.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "scene_io/text/file.h"
#include "tools/candela/memory_need.h"
#include "tools/candela/option_values.h"

namespace candela::cli {
namespace {

// A sentence and the code to end with; thrown and caught in this file only.
struct Refusal {
  std::string sentence;
  ExitCode exit_code;
};

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

std::string_view integrator_name(const RenderOptions& options) {
  return name_of(options.integrator, integrator_choices());
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

void refuse_what_only_path_does(const RenderArguments& arguments, const RenderOptions& options) {
  if (options.integrator == IntegratorKind::Path) return;
  const auto refuse = [&](bool is_said, std::string_view option) {
    if (is_said)
      throw Refusal{fmt::format("{} is for path, this is {}", option, integrator_name(options)),
                    ExitCode::Usage};
  };
  refuse(options.adaptive, "--adaptive");
  refuse(arguments.uses_general_kernel, "--kernel general");
  refuse(arguments.splitting.has_value(), "--splitting");
  refuse(arguments.reuses_paths.has_value(), "--reuse");
  refuse(arguments.roulette.has_value(), "--roulette");
  refuse(arguments.guiding.has_value(), "--guiding");
  refuse(arguments.sampler.has_value(), "--sampler");
  refuse(arguments.samples_constant_sky.has_value(), "--sky-samples");
  refuse(arguments.compensates_sky.has_value(), "--sky-compensation");
  refuse(arguments.lamp_rays.has_value(), "--lamp-rays");
  refuse(arguments.light_sampling.has_value(), "--light-sampling");
  refuse(arguments.light_cells.has_value(), "--light-cells");
  const std::string_view saving = saving_of_path(arguments.without);
  refuse(!saving.empty(), fmt::format("--without {}", saving));
}

// What paths cannot be shared with: several from a first hit, or directions that others learned.
void refuse_reuse(const RenderOptions& options) {
  if (!options.plan.reuses_paths) return;
  const auto refuse = [](bool is_said, std::string_view option) {
    if (is_said)
      throw Refusal{fmt::format("--reuse on and {}: paths are shared where one goes on from each "
                                "first hit, by its surface alone",
                                option),
                    ExitCode::Usage};
  };
  refuse(options.plan.splitting > 1, fmt::format("--splitting {}", options.plan.splitting));
  refuse(options.guiding != Guiding::Off,
         fmt::format("--guiding {}", name_of(options.guiding, guiding_choices())));
}

void refuse_savings(const RenderArguments& arguments, const RenderOptions& options) {
  if (has(arguments.without, Saving::OpacityGrids) && is_lab_shading(options.integrator))
    throw Refusal{fmt::format("--without opacity-grids is for path and report, this is {}",
                              integrator_name(options)),
                  ExitCode::Usage};
  const std::string_view saving = saving_of_embree(arguments.without);
  if (!saving.empty() && arguments.accelerator == AcceleratorKind::Bvh)
    throw Refusal{fmt::format("--without {} is for Embree, this is --accel bvh", saving),
                  ExitCode::Usage};
}

// What draws nothing at random has no error to state, and a grid is complete or has gaps.
void refuse_stop_rules(const RenderArguments& arguments, const RenderOptions& options) {
  const auto refuse = [&](bool is_said, std::string_view option) {
    if (is_said)
      throw Refusal{
          fmt::format("{} is for path and report, this is {}", option, integrator_name(options)),
          ExitCode::Usage};
  };
  if (is_lab_shading(options.integrator)) {
    refuse(arguments.error_goal.has_value(), "--error");
    refuse(arguments.relmse_goal.has_value(), "--relmse");
    refuse(arguments.time_limit_seconds.has_value(), "--time");
    refuse(arguments.replicates.has_value(), "--replicates");
    refuse(arguments.clamp.has_value(), "--clamp");
  }
  if (options.target_relmse && options.replicates < 2)
    throw Refusal{fmt::format("{} needs an error to go by, and --replicates 1 states none",
                              arguments.error_goal ? "--error" : "--relmse"),
                  ExitCode::Usage};
  if (arguments.measures_ray_limit && may_end_early(options) && !arguments.samples_per_pixel)
    throw Refusal{"--ray-limit needs --spp, since no number of samples is known beforehand",
                  ExitCode::Usage};
}

void settle_stop_rules(const RenderArguments& arguments, RenderOptions& options) {
  options.replicates = arguments.replicates.value_or(options.replicates);
  options.adaptive = arguments.adaptive.value_or(options.integrator == IntegratorKind::Path &&
                                                 options.replicates > 1);
  options.plan.splitting = static_cast<std::uint32_t>(arguments.splitting.value_or(1));
  const PathSharing sharing = arguments.reuses_paths.value_or(PathSharing{});
  options.plan.reuses_paths = sharing.is_on.value_or(false);
  options.chooses_reuse = !sharing.is_on;
  const RouletteThreshold roulette = arguments.roulette.value_or(RouletteThreshold{});
  options.plan.roulette_threshold =
      static_cast<float>(roulette.threshold.value_or(default_roulette_threshold));
  options.chooses_roulette = !roulette.threshold;
  options.guiding = arguments.guiding.value_or(options.guiding);
  options.use_general_kernel = arguments.uses_general_kernel;
  options.savings = path_savings_without(arguments.without);
  if (arguments.error_goal) options.target_relmse = *arguments.error_goal * *arguments.error_goal;
  if (arguments.relmse_goal)
    options.target_relmse =
        std::min(*arguments.relmse_goal, options.target_relmse.value_or(*arguments.relmse_goal));
  options.time_limit_seconds = arguments.time_limit_seconds;
  if (arguments.clamp) options.clamp = static_cast<float>(*arguments.clamp);
  if (!(options.clamp > 0))
    throw Refusal{fmt::format("--clamp {} would leave no light", *arguments.clamp),
                  ExitCode::Usage};
  refuse_what_only_path_does(arguments, options);
  refuse_reuse(options);
  refuse_savings(arguments, options);
  refuse_stop_rules(arguments, options);
}

void settle_samples(const RenderArguments& arguments, const description::RenderDefaults& defaults,
                    RenderOptions& options, std::vector<std::string>& warnings) {
  constexpr int lab_samples = 16;
  if (is_lab_shading(options.integrator)) options.samples_per_pixel = lab_samples;
  if (may_end_early(options) && !arguments.samples_per_pixel) {
    options.samples_per_pixel = max_samples_per_pixel;
    options.seed = arguments.seed.value_or(defaults.seed.value_or(options.seed));
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
  options.seed = arguments.seed.value_or(defaults.seed.value_or(options.seed));
}

void settle_names(const RenderArguments& arguments, const description::RenderDefaults& defaults,
                  RenderOptions& options) {
  if (arguments.integrator)
    options.integrator = *arguments.integrator;
  else if (defaults.integrator)
    options.integrator = scene_choice("integrator", *defaults.integrator, integrator_choices());
  if (arguments.filter)
    options.filter = *arguments.filter;
  else if (defaults.filter)
    options.filter = scene_choice("filter", *defaults.filter, filter_choices());
  options.white_balance_kelvins = defaults.white_balance_kelvins;
  if (defaults.filter_radius && !arguments.filter)
    options.filter_radius = static_cast<float>(*defaults.filter_radius);
}

void settle_depth(const RenderArguments& arguments, const description::RenderDefaults& defaults,
                  RenderOptions& options) {
  constexpr int whitted_depth = 5;
  options.max_depth = arguments.max_depth ? arguments.max_depth->depth : defaults.max_depth;
  if (options.integrator == IntegratorKind::Whitted) {
    if (arguments.max_depth && !arguments.max_depth->depth)
      throw Refusal{"--max-depth none: whitted needs a limit, such as 5", ExitCode::Usage};
    options.max_depth = options.max_depth.value_or(whitted_depth);
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

void refuse_sampling(const RenderArguments& arguments, const RenderOptions& options) {
  const std::string_view name = integrator_name(options);
  if ((arguments.sampling || arguments.heuristic) && is_lab_shading(options.integrator))
    throw Refusal{fmt::format("{} is for path and report, this is {}",
                              arguments.sampling ? "--sampling" : "--heuristic", name),
                  ExitCode::Usage};
  const bool is_report = options.integrator == IntegratorKind::Report;
  if (is_report &&
      (options.sampling == SamplingStrategy::Bsdf || arguments.sampling == SamplingStrategy::Mis))
    throw Refusal{
        fmt::format("--sampling {}: the report integrator always samples its lamps alone; "
                    "expected light, cosine or uniform",
                    name_of(options.sampling, sampling_choices())),
        ExitCode::Usage};
  if (arguments.heuristic && (is_report || options.sampling != SamplingStrategy::Mis))
    throw Refusal{"--heuristic weights the strategies of path with --sampling mis",
                  ExitCode::Usage};
  if (arguments.measures_ray_limit && (arguments.sampling || arguments.heuristic))
    throw Refusal{"--ray-limit measures the default kernels: not with --sampling or --heuristic",
                  ExitCode::Usage};
}

void refuse_guiding(const RenderArguments& arguments) {
  if (arguments.guiding.value_or(Guiding::Off) == Guiding::Off) return;
  if (arguments.sampling.value_or(SamplingStrategy::Mis) != SamplingStrategy::Mis ||
      arguments.heuristic == Heuristic::Balance)
    throw Refusal{"--guiding is for --sampling mis --heuristic power", ExitCode::Usage};
  if (arguments.measures_ray_limit)
    throw Refusal{"--ray-limit measures the default kernels: not with --guiding", ExitCode::Usage};
}

// What the chosen integrator has no use for.
void refuse_what_does_not_fit(const RenderArguments& arguments, const RenderOptions& options) {
  const std::string_view name = integrator_name(options);
  if ((arguments.specular || arguments.has_lab_normals) && !is_lab_shading(options.integrator))
    throw Refusal{fmt::format("{} is for whitted and raster, this is {}",
                              arguments.specular ? "--specular" : "--lab-normals", name),
                  ExitCode::Usage};
  if (arguments.filter && *arguments.filter != FilterKind::Box &&
      is_lab_shading(options.integrator))
    throw Refusal{fmt::format("--filter {}: {} averages its grid of samples, which is a box filter",
                              name_of(*arguments.filter, filter_choices()), name),
                  ExitCode::Usage};
  if (arguments.measures_ray_limit && options.integrator != IntegratorKind::Path)
    throw Refusal{fmt::format("--ray-limit measures the path integrator, this is {}", name),
                  ExitCode::Usage};
  if (arguments.report_p_rr && options.integrator != IntegratorKind::Report)
    throw Refusal{fmt::format("--rr is an option of the report integrator, this is {}", name),
                  ExitCode::Usage};
}

RenderSettings settled(const RenderArguments& arguments,
                       const description::SceneDescription& description, MemoryNeed need) {
  RenderSettings settings;
  RenderOptions& options = settings.options;
  settle_size(arguments, description.defaults, options);
  settle_crop(arguments, description.defaults, options);
  settle_names(arguments, description.defaults, options);
  settle_stop_rules(arguments, options);
  settle_samples(arguments, description.defaults, options, settings.warnings);
  settle_depth(arguments, description.defaults, options);
  settle_camera(arguments, description, options);
  options.report_p_rr = static_cast<float>(arguments.report_p_rr.value_or(options.report_p_rr));
  options.aovs = arguments.aovs;
  options.transparent = arguments.is_transparent;
  options.lab_normals = arguments.has_lab_normals;
  options.specular = arguments.specular.value_or(options.specular);
  options.sampling = arguments.sampling.value_or(options.sampling);
  options.heuristic = arguments.heuristic.value_or(options.heuristic);
  options.sampler = arguments.sampler.value_or(options.sampler);
  options.samples_constant_sky =
      arguments.samples_constant_sky.value_or(options.samples_constant_sky);
  options.compensates_sky = arguments.compensates_sky.value_or(options.compensates_sky);
  constexpr int default_lamp_rays = 8;
  options.lamp_rays = arguments.lamp_rays.value_or(default_lamp_rays);
  options.light_sampling = arguments.light_sampling.value_or(options.light_sampling);
  options.light_cells = arguments.light_cells.value_or(options.light_cells);
  refuse_what_does_not_fit(arguments, options);
  refuse_sampling(arguments, options);
  refuse_guiding(arguments);
  if (is_lab_shading(options.integrator)) {
    options.filter = FilterKind::Box;
    options.filter_radius.reset();
  }
  if (need == MemoryNeed::Heeded)
    if (const std::optional<std::string> sentence = missing_memory(options))
      throw Refusal{*sentence, ExitCode::Limit};
  settings.display = {arguments.tone_map,
                      arguments.exposure.value_or(description.defaults.exposure.value_or(0))};
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
