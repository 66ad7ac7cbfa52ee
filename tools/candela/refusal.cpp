#include "tools/candela/refusal.h"

#include <string_view>

#include <fmt/format.h>

#include "tools/candela/option_values.h"

namespace candela::cli {
namespace {

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
  if (!arguments.embree.robust && arguments.accelerator == AcceleratorKind::Bvh)
    throw Refusal{"--robust off is for Embree, this is --accel bvh", ExitCode::Usage};
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

// What is about samples that are not taken.
void refuse_samples_of_lights(const RenderArguments& arguments) {
  const auto refuse = [](bool is_said, std::string_view option) {
    if (is_said)
      throw Refusal{
          fmt::format("{} is about samples of lights, of which --sampling bsdf takes none", option),
          ExitCode::Usage};
  };
  refuse(arguments.samples_constant_sky.has_value(), "--sky-samples");
  refuse(arguments.light_sampling.has_value(), "--light-sampling");
  refuse(arguments.light_cells.has_value(), "--light-cells");
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
  if (options.sampling == SamplingStrategy::Bsdf) refuse_samples_of_lights(arguments);
  if (arguments.compensates_sky && options.sampling != SamplingStrategy::Mis)
    throw Refusal{"--sky-compensation is about the strategies of path with --sampling mis",
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

void refuse_clamp(const RenderArguments& arguments, const RenderOptions& options) {
  if (!(options.clamp > 0))
    throw Refusal{fmt::format("--clamp {} would leave no light", *arguments.clamp),
                  ExitCode::Usage};
}

// What the chosen integrator has no use for.
void refuse_what_another_does(const RenderArguments& arguments, const RenderOptions& options) {
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

}  // namespace

void refuse_what_does_not_fit(const RenderArguments& arguments, const RenderOptions& options) {
  refuse_clamp(arguments, options);
  refuse_what_only_path_does(arguments, options);
  refuse_reuse(options);
  refuse_savings(arguments, options);
  refuse_stop_rules(arguments, options);
  refuse_what_another_does(arguments, options);
  refuse_sampling(arguments, options);
  refuse_guiding(arguments);
}

}  // namespace candela::cli
