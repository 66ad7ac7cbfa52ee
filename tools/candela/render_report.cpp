#include "tools/candela/render_report.h"

#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace candela::cli {
namespace {

std::string depth_text(const std::optional<int>& max_depth) {
  return max_depth ? std::to_string(*max_depth) : "none";
}

std::string lab_text(const RenderOptions& options) {
  if (!is_lab_shading(options.integrator)) return "";
  return fmt::format(" specular={} lab_normals={}", name_of(options.specular, specular_choices()),
                     options.lab_normals ? "yes" : "no");
}

std::string strategy_text(const RenderReport& report) {
  const RenderOptions& options = report.options;
  switch (options.integrator) {
    case IntegratorKind::Path:
      return fmt::format(
          " roulette={}/{} sampling={} heuristic={} sampler={} sky_samples={} sky_compensation={} "
          "lamp_rays={} light_sampling={} light_cells={}",
          report.statistics.plan.roulette_threshold, report.statistics.plan.roulette().first_bounce,
          sampling_name(options), name_of(options.heuristic, heuristic_choices()),
          name_of(options.sampler, sampler_choices()), options.samples_constant_sky ? "on" : "off",
          options.compensates_sky ? "on" : "off", options.lamp_rays,
          name_of(options.light_sampling, light_sampling_choices()),
          options.light_cells ? "on" : "off");
    case IntegratorKind::Report:
      return fmt::format(" sampling={} rr={}", sampling_name(options), options.report_p_rr);
    case IntegratorKind::Whitted:
    case IntegratorKind::Raster:
      return "";
  }
  return "";
}

std::string balance_text(const RenderOptions& options) {
  if (!options.white_balance_kelvins) return "";
  return fmt::format(" white_balance={}", *options.white_balance_kelvins);
}

std::string guiding_text(const RenderOptions& options) {
  if (options.guiding == Guiding::Off) return "";
  return fmt::format(" guiding={}", name_of(options.guiding, guiding_choices()));
}

std::string without_text(const RenderReport& report) {
  return report.without == 0 ? "" : " without=" + savings_text(report.without);
}

// What decides the pixels beside the scene and what biases them, in one line; what makes another
// scene of it (--ambient, --materials, --fresnel, --geometry) stands in the command.
std::string options_text(const RenderReport& report) {
  const RenderOptions& options = report.options;
  const PixelRect crop = report.rect();
  return fmt::format(
      "size={}x{} crop={},{},{},{} camera={} max_depth={} filter={} filter_radius={} "
      "transparent={} accel={} robust={}{} replicates={} adaptive={} splitting={} reuse={}{}{}{}{}",
      options.width, options.height, crop.x0, crop.y0, crop.x1, crop.y1, options.camera,
      depth_text(options.max_depth), name_of(options.filter, filter_choices()),
      make_filter(options).radius(), options.transparent ? "yes" : "no",
      name_of(report.accelerator, accelerator_choices()), report.is_robust ? "on" : "off",
      without_text(report), report.replicates, options.adaptive ? "on" : "off",
      report.statistics.plan.splitting, report.statistics.plan.reuses_paths ? "on" : "off",
      guiding_text(options), lab_text(options), strategy_text(report), balance_text(options));
}

}  // namespace

std::string_view sampling_name(const RenderOptions& options) {
  const bool is_own =
      options.integrator == IntegratorKind::Report && options.sampling == SamplingStrategy::Mis;
  return name_of(is_own ? SamplingStrategy::Light : options.sampling, sampling_choices());
}

std::string_view stop_name(StopReason stop) {
  switch (stop) {
    case StopReason::Samples:
      return "spp";
    case StopReason::Error:
      return "error";
    case StopReason::Time:
      return "time";
    case StopReason::Cancelled:
      return "interrupted";
  }
  return "";
}

std::vector<std::string> biases_of(const RenderOptions& options) {
  std::vector<std::string> biases;
  if (std::isfinite(options.clamp)) biases.push_back(fmt::format("clamp {}", options.clamp));
  if (options.max_depth && !is_lab_shading(options.integrator))
    biases.push_back(fmt::format("max depth {}", *options.max_depth));
  return biases;
}

std::vector<std::string> biases_of(const RenderReport& report) {
  std::vector<std::string> biases = biases_of(report.options);
  if (report.statistics.stop == StopReason::Error) biases.emplace_back("ended by its own error");
  return biases;
}

std::uint64_t peak_memory_bytes() {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word) {
    if (word != "VmHWM:") continue;
    std::uint64_t kibibytes = 0;
    status >> kibibytes;
    return kibibytes * 1024;
  }
  return 0;
}

Metadata metadata_of(const RenderReport& report) {
  const auto integer = [](std::uint64_t value) { return static_cast<std::int64_t>(value); };
  const RenderStatistics& statistics = report.statistics;
  Metadata metadata{
      {"Software", "candela " CANDELA_VERSION},
      {"candela:version", CANDELA_VERSION},
      {"candela:command", report.command},
      {"candela:scene", report.scene},
      {"candela:scene_hash", report.scene_hash},
      {"candela:integrator", std::string(integrator_name(report.options))},
      {"candela:options", options_text(report)},
      {"candela:kernel", statistics.kernel},
      {"candela:seed", std::to_string(report.options.seed)},
      {"candela:spp", integer(report.min_samples)},
      {"candela:spp_max", integer(report.max_samples)},
      {"candela:spp_mean", report.mean_samples},
      {"candela:interrupted", integer(report.is_interrupted() ? 1 : 0)},
      {"candela:invalid_samples", integer(statistics.invalid_samples)},
      {"candela:threads", std::int64_t{report.threads}},
      {"candela:seconds_load", report.seconds.load},
      {"candela:seconds_compile", report.seconds.compile},
      {"candela:seconds_build", report.seconds.build},
      {"candela:seconds_render", report.seconds.render},
      {"candela:stop", std::string(stop_name(statistics.stop))},
  };
  if (report.error) {
    metadata.push_back({"candela:relmse", report.error->relmse});
    metadata.push_back({"candela:rmse", report.error->rmse});
    metadata.push_back({"candela:relmse_low", report.error->interval95.low});
    metadata.push_back({"candela:relmse_high", report.error->interval95.high});
    metadata.push_back({"candela:heavy_tails", report.error->heavy_tails});
  }
  const std::vector<std::string> biases = biases_of(report);
  if (!biases.empty())
    metadata.push_back({"candela:biased", fmt::format("{}", fmt::join(biases, ", "))});
  return metadata;
}

}  // namespace candela::cli
