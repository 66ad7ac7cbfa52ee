#include "tools/candela/render_run.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/counted.h"
#include "renderer/base/parallel.h"
#include "renderer/image/image_format.h"
#include "tools/candela/decode_textures.h"
#include "tools/candela/interrupt.h"
#include "tools/candela/json_reports.h"
#include "tools/candela/option_values.h"
#include "tools/candela/output_files.h"
#include "tools/candela/render_settings.h"
#include "tools/candela/scene_hash.h"
#include "tools/candela/unmet_requests.h"

namespace candela::cli {
namespace {

std::string samples_text(const RenderReport& report) {
  if (report.min_samples == report.max_samples) return fmt::format("{} spp", report.min_samples);
  return fmt::format("{:.1f} spp ({} to {})", report.mean_samples, report.min_samples,
                     report.max_samples);
}

bool shows_sky_alone(const Scene& scene) {
  return scene.geometries.empty() && scene.environment && scene.environment->is_seen_by_camera &&
         !scene.environment->is_black();
}

// What the render is to stop at.
std::string rules_text(const RenderReport& report) {
  const RenderOptions& options = report.options;
  std::vector<std::string> rules;
  if (report.has_sample_limit()) rules.push_back(fmt::format("{} spp", options.samples_per_pixel));
  if (options.target_relmse)
    rules.push_back("an error of " + error_text(std::sqrt(*options.target_relmse)));
  if (options.time_limit_seconds)
    rules.push_back(fmt::format("{:g} s", *options.time_limit_seconds));
  return fmt::format("{}", fmt::join(rules, " or "));
}

// The option that asked for an error; of both the harder one.
std::string_view goal_option(const RenderArguments& arguments) {
  const bool is_rmse = arguments.error_goal &&
                       square(*arguments.error_goal) <=
                           arguments.relmse_goal.value_or(std::numeric_limits<double>::infinity());
  return is_rmse ? "error" : "relmse";
}

// What it did stop at, and the error. `goal`: the option that asked for one.
std::string stop_text(const RenderReport& report, std::string_view goal) {
  const std::string samples = samples_text(report);
  const std::string error =
      report.error ? ", error " + error_text(stated_error(*report.error)) : "";
  const StopReason stop = report.statistics.stop;
  if (stop == StopReason::Samples) return "all of " + samples + error;
  const std::string_view option = stop == StopReason::Error ? goal : stop_name(stop);
  return fmt::format("stopped by --{} at {}{}", option, samples, error);
}

bool is_exr(const std::string& path) {
  return format_of_extension(path) == ImageFormat::Exr;
}

bool lacks_alpha(const std::string& path) {
  const auto format = format_of_extension(path);
  return format == ImageFormat::Jpeg || format == ImageFormat::Hdr;
}

bool is_cook_torrance(const description::Material& material) {
  return std::holds_alternative<description::CookTorranceMaterial>(material.model);
}

bool is_for_display(const std::string& path) {
  const auto format = format_of_extension(path);
  return format == ImageFormat::Png || format == ImageFormat::Jpeg;
}

std::uint64_t triangle_count(const Scene& scene) {
  std::uint64_t count = 0;
  for (const Geometry& geometry : scene.geometries) count += geometry.triangles.size();
  return count;
}

std::size_t undecoded_textures(const TextureStore& textures) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < textures.size(); ++i)
    if (!textures.is_decoded(TextureHandle(i))) ++count;
  return count;
}

}  // namespace

RenderRun::RenderRun(const RenderArguments& arguments)
    : arguments_(arguments), console_(arguments.is_quiet) {
  report_.command = arguments.command_line;
  report_.scene = arguments.scene.path;
  report_.accelerator = arguments.accelerator;
  report_.is_robust = arguments.embree.robust;
  report_.without = arguments.without;
  report_.threads = arguments.threads > 0 ? arguments.threads : available_threads();
}

std::vector<std::string> RenderRun::all_paths() const {
  std::vector<std::string> paths = output_paths(arguments_);
  if (arguments_.stats_path) paths.push_back(*arguments_.stats_path);
  return paths;
}

bool RenderRun::stop(ExitCode code) {
  fail(code);
  return false;
}

// The first reason to end otherwise than with Done counts.
void RenderRun::fail(ExitCode code) {
  if (exit_code_ == ExitCode::Done) exit_code_ = code;
}

void RenderRun::warn(const std::string& sentence) {
  console_.warning(sentence);
  report_.warnings.push_back(sentence);
}

void RenderRun::record(const Diagnostics& diagnostics) {
  console_.print(diagnostics);
  std::size_t kept = 0;
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    if (diagnostic.severity != Severity::Warning) continue;
    report_.warnings.push_back(to_string(diagnostic));
    ++kept;
  }
  if (diagnostics.warning_count() > kept)
    report_.warnings.push_back(
        fmt::format("{} further warnings", diagnostics.warning_count() - kept));
}

bool RenderRun::accepts(const Diagnostics& diagnostics, bool has_value) {
  record(diagnostics);
  if (diagnostics.has_errors() || !has_value) return stop(ExitCode::Scene);
  return allows(diagnostics.warning_count());
}

bool RenderRun::allows(std::size_t warnings) {
  if (!arguments_.scene.is_strict || warnings == 0) return true;
  console_.strict_error(warnings, report_.scene);
  return stop(ExitCode::Scene);
}

bool RenderRun::outputs_are_writable() {
  const OutputCheck check = check_outputs(output_paths(arguments_), arguments_.stats_path);
  console_.print(check.diagnostics);
  return check.exit_code == ExitCode::Done || stop(check.exit_code);
}

bool RenderRun::settles(const description::SceneDescription& description) {
  const Diagnostics overwritten = check_scene_is_spared(all_paths(), description);
  console_.print(overwritten);
  if (overwritten.has_errors()) return stop(ExitCode::Output);
  const SettledSettings settled = settle_settings(arguments_, description);
  if (!settled.settings) {
    console_.error(settled.error);
    return stop(settled.exit_code);
  }
  report_.options = settled.settings->options;
  const PixelRect rect = report_.rect();
  const Diagnostics too_large =
      check_image_sizes(output_paths(arguments_), rect.width(), rect.height());
  console_.print(too_large);
  if (too_large.has_errors()) return stop(ExitCode::Output);
  report_.display = settled.settings->display;
  std::vector<std::string> warnings = settled.settings->warnings;
  for (const std::string& sentence : warnings_of_options(description)) warnings.push_back(sentence);
  for (const std::string& sentence : warnings) warn(sentence);
  if (!allows(warnings.size())) return false;
  if (!accepts(check_integrator(description, report_.options), true)) return false;
  report_.scene_hash = timed(&StageSeconds::load, [&] { return scene_hash(description); });
  return true;
}

std::vector<std::string> RenderRun::warnings_of_options(
    const description::SceneDescription& description) const {
  std::vector<std::string> warnings;
  const std::vector<std::string> paths = output_paths(arguments_);
  if (arguments_.aovs != 0 && std::none_of(paths.begin(), paths.end(), is_exr))
    warnings.push_back("--aov: only an EXR output can hold further layers, and none is asked for");
  if (arguments_.is_transparent && std::all_of(paths.begin(), paths.end(), lacks_alpha))
    warnings.push_back("--transparent: no output can hold alpha; expected EXR, PNG or TIFF");
  const bool is_for_screens = arguments_.exposure || arguments_.tone_map != ToneMap::Srgb;
  if (is_for_screens && std::none_of(paths.begin(), paths.end(), is_for_display))
    warnings.push_back("--exposure and --tonemap: no output is for screens; expected PNG or JPEG");
  const LoadOptions& load = arguments_.scene.load;
  if ((load.fresnel || load.geometry) &&
      std::ranges::none_of(description.materials, is_cook_torrance))
    warnings.push_back("--fresnel and --geometry: there is no material of the type cook_torrance");
  if (std::isfinite(options().clamp))
    warnings.push_back(
        fmt::format("clamp {}: the picture is biased, it lacks light", options().clamp));
  return warnings;
}

// With --strict a texture that cannot be decoded is an error: found now and not after the render.
bool RenderRun::accepts_scene(const Scene& scene) {
  // Such scenes are lit by an environment that only path sees.
  if (is_lab_shading(options().integrator) && !has_light(scene, options())) {
    warn(
        fmt::format("{} sees no light in this scene: it knows point, spot and directional lights, "
                    "lamps and the ambient term",
                    integrator_name(options())));
    if (!allows(1)) return false;
  }
  if (is_lab_shading(options().integrator) && shows_sky_alone(scene)) {
    warn(fmt::format("{} draws surfaces alone, of which there are none: there is nothing to see",
                     integrator_name(options())));
    if (!allows(1)) return false;
  }
  const std::vector<std::string> unmet = unmet_requests(arguments_, scene, options());
  for (const std::string& sentence : unmet) warn(sentence);
  if (!allows(unmet.size())) return false;
  if (!arguments_.scene.is_strict) return true;
  decode_all_textures(scene.textures);
  return accepts(scene.textures.decoding_diagnostics(), true);
}

ProgressSink* RenderRun::start_rendering(const Scene& scene) {
  set_interrupt_mode(InterruptMode::Cancel);
  const PixelRect crop = report_.rect();
  report_.triangles = triangle_count(scene);
  console_.note(fmt::format("{}: {} triangles, {}x{}, {}, {}, {}", report_.scene, report_.triangles,
                            crop.width(), crop.height(), rules_text(report_),
                            integrator_name(options()),
                            counted(static_cast<std::size_t>(report_.threads), "thread")));
  progress_ = std::make_unique<ProgressReport>(console_);
  return arguments_.is_quiet ? nullptr : progress_.get();  // its numbers cost a little
}

void RenderRun::rendered(const Scene& scene, const RenderResult& result, double decoding) {
  report_.decoding_cpu_seconds = decoding;
  report_.statistics = result.statistics;
  report_.min_samples = result.film.min_samples();
  report_.max_samples = result.film.max_samples();
  report_.mean_samples = result.film.mean_samples();
  report_.replicates = result.film.replicates();
  report_.error = result.error;
  report_.skipped_textures = undecoded_textures(scene.textures);
  if (!arguments_.scene.is_strict) record(scene.textures.decoding_diagnostics());
  report_invalid_samples();
  if (lacks_guides(scene, report_))
    warn("--guiding on: no paths were guided, since too little was learned");
  report_reliability();
}

void RenderRun::report_reliability() {
  constexpr double negligible = 1e-2;
  const bool has_two_replicates = std::min(report_.min_samples, report_.replicates) >= 2;
  if (!report_.error && has_two_replicates)
    warn("no sample has met light, though the scene has some: the picture's error is not known");
  if (report_.error && report_.error->relmse > 0 && report_.min_samples < 3)
    warn(
        "two samples a pixel know little of their error: the stated one is likely too small "
        "(three do)");
  // Fewer samples a replicate say little about tails.
  const bool is_telling = report_.min_samples >= 4 * std::min(report_.replicates, 4u);
  if (report_.error && is_telling && report_.error->heavy_tails > negligible)
    warn(
        fmt::format("in {:.1f} % of the pixels rare strong samples hold most of the light: the "
                    "stated error may be too small (--aov heavy_tail shows where)",
                    report_.error->heavy_tails * 100));
  if (report_.max_samples == 0) return;  // nothing is written
  if (report_.min_samples == 0)
    warn(report_.statistics.stop == StopReason::Time
             ? "the time did not suffice for one sample in every pixel; those without are black"
             : "not every pixel has a sample; those without are black");
  if (report_.min_samples < 2 && options().samples_per_pixel > 1 && report_.replicates > 1 &&
      (options().aovs & layers_of_errors) != 0)
    warn(
        "the render ended before every pixel had two samples: the layers variance, interval and "
        "heavy_tail tell nothing");
}

void RenderRun::report_invalid_samples() {
  const RenderStatistics& statistics = report_.statistics;
  if (statistics.invalid_samples == 0) return;
  const InvalidSample first = statistics.first_invalid.value_or(InvalidSample{});
  warn(
      fmt::format("{} samples were not finite and count as black, the first at pixel {},{}, "
                  "sample {}: this is a bug in candela",
                  statistics.invalid_samples, first.x, first.y, first.sample));
}

std::vector<std::string> RenderRun::outputs() const {
  return report_.max_samples > 0 ? output_paths(arguments_) : std::vector<std::string>{};
}

WriteOptions RenderRun::write_options() const {
  WriteOptions write;
  write.display = report_.display;
  write.metadata = metadata_of(report_);
  if (options().crop) {
    write.offset_x = options().crop->x0;
    write.offset_y = options().crop->y0;
  }
  write.full_width = options().width;
  write.full_height = options().height;
  return write;
}

void RenderRun::wrote(const std::string& path, const Diagnostics& problems) {
  record(problems);
  if (problems.has_errors())
    fail(ExitCode::Output);
  else
    report_.outputs.push_back(path);
}

void RenderRun::report_samples() {
  if (report_.statistics.stop == StopReason::Time && report_.max_samples == 0) {
    console_.error("the time did not suffice for a single sample; nothing was written");
    return fail(ExitCode::Limit);
  }
  if (!report_.is_interrupted()) return;
  fail(ExitCode::Interrupted);
  if (report_.max_samples == 0)
    console_.error("interrupted before the first sample; nothing was written");
  else
    console_.error(fmt::format(
        "interrupted; the picture holds {}{}", samples_text(report_),
        report_.has_sample_limit() ? fmt::format(" of {}", options().samples_per_pixel) : ""));
}

void RenderRun::write_stats() {
  if (!arguments_.stats_path || report_.max_samples == 0) return;
  report_.peak_memory_bytes = peak_memory_bytes();
  set_interrupt_mode(InterruptMode::Finish);
  const Diagnostics problems = write_file_atomically(*arguments_.stats_path, to_json(report_));
  console_.print(problems);
  if (problems.has_errors()) fail(ExitCode::Output);
}

// The picture is complete and on disk: interrupting costs the measurement alone.
void RenderRun::measure_ray_limit(const Scene& scene, const AnyAccelerator& accelerator) {
  set_interrupt_mode(InterruptMode::Cancel);
  report_.ray_limit = candela::measure_ray_limit(scene, accelerator, options(), &cancel_flag());
  if (!report_.ray_limit) {
    console_.error("interrupted while the ray limit was measured; the picture is complete");
    return fail(ExitCode::Interrupted);
  }
  console_.note(
      fmt::format("ray limit {:.3f}: {:.3f} s of CPU time for a share of the tiles, "
                  "{:.3f} s for their {} rays alone",
                  report_.ray_limit->ratio(), report_.ray_limit->render_seconds,
                  report_.ray_limit->rays_seconds, report_.ray_limit->rays));
}

ExitCode RenderRun::finish(const Scene& scene, const std::optional<AnyAccelerator>& accelerator) {
  const ProgressState state = progress_->state();
  progress_->stop();
  report_samples();
  if (exit_code_ == ExitCode::Done)
    console_.note(fmt::format(
        "100 %, {} elapsed, {:.2f} Msamples/s; {}; wrote {}", duration_text(state.elapsed_seconds),
        static_cast<double>(state.done) * 1e-6 / report_.seconds.render,
        stop_text(report_, goal_option(arguments_)), fmt::join(report_.outputs, ", ")));
  else if (!report_.outputs.empty())
    console_.note(fmt::format("wrote {}", fmt::join(report_.outputs, ", ")));
  if (accelerator && arguments_.measures_ray_limit && !report_.is_interrupted())
    measure_ray_limit(scene, *accelerator);
  write_stats();
  return exit_code_;
}

}  // namespace candela::cli
