#include "tools/candela/unmet_requests.h"

#include <fmt/format.h>

#include "integrators/feasible_options.h"
#include "integrators/pilot.h"

namespace candela::cli {
namespace {

std::string why_no_pilot(const RenderOptions& options) {
  if (!is_wide_enough_for_pilot(options)) return "the picture has but one row or column";
  return fmt::format("with {} samples a pixel there is no pilot, which takes {}",
                     options.samples_per_pixel, least_samples_for_pilot(options));
}

bool has_constant_sky(const Scene& scene) {
  return scene.environment && scene.environment->is_constant() && !scene.environment->is_black();
}

}  // namespace

std::vector<std::string> unmet_requests(const RenderArguments& arguments, const Scene& scene,
                                        const RenderOptions& options) {
  const RenderOptions feasible = feasible_options(scene, options);
  std::vector<std::string> sentences;
  if (arguments.adaptive.value_or(false) && pilot_of(feasible).samples == 0)
    sentences.push_back(fmt::format("--adaptive on: {}; all pixels get the same number of samples",
                                    why_no_pilot(feasible)));
  if (feasible.plan.splitting < options.plan.splitting)
    sentences.push_back(
        fmt::format("--splitting {}: paths through media are not split", options.plan.splitting));
  if (options.plan.reuses_paths && !feasible.plan.reuses_paths)
    sentences.emplace_back(
        "--reuse on: the scene and the options have no paths that pixels could share");
  if (arguments.samples_constant_sky.value_or(false) && !has_constant_sky(scene))
    sentences.emplace_back("--sky-samples on: there is no sky of one colour");
  if (options.guiding == Guiding::On && feasible.guiding == Guiding::Off)
    sentences.emplace_back("--guiding on: paths through media are not guided");
  const std::uint32_t replicates = film_replicates(options);
  if ((options.aovs & layers_of_errors) != 0 && replicates < 2)
    sentences.emplace_back(
        "--aov: no error is known without two replicates and a sample of each: variance, interval "
        "and heavy_tail are 0");
  if (options.target_relmse && replicates < 2)
    sentences.emplace_back("no error is known of one sample a pixel, so that none ends the render");
  return sentences;
}

bool lacks_guides(const Scene& scene, const RenderReport& report) {
  return feasible_options(scene, report.options).guiding == Guiding::On &&
         !report.is_interrupted() && report.statistics.guiding.guided_cells == 0;
}

}  // namespace candela::cli
