#include "integrators/render_options.h"

#include <algorithm>

#include "renderer/math/white_balance.h"

namespace candela {

RenderOptions usual_options(IntegratorKind integrator) {
  RenderOptions options;
  options.integrator = integrator;
  options.plan.roulette_threshold = default_roulette_threshold;
  if (integrator == IntegratorKind::Path) {
    options.adaptive = true;
    options.chooses_roulette = true;
    options.chooses_reuse = true;
    options.lamp_rays = 8;
  }
  if (is_lab_shading(integrator)) options.samples_per_pixel = 16;
  return options;
}

std::uint32_t film_replicates(const RenderOptions& options) {
  if (is_lab_shading(options.integrator)) return 1;
  return static_cast<std::uint32_t>(
      std::clamp(options.replicates, 1, std::max(options.samples_per_pixel, 1)));
}

std::optional<Mat3d> film_balance(const RenderOptions& options) {
  if (!options.white_balance_kelvins) return std::nullopt;
  return white_balance(*options.white_balance_kelvins);
}

CompileOptions compile_options(const RenderOptions& options) {
  const bool is_lab = is_lab_shading(options.integrator);
  return {
      .width = options.width,
      .height = options.height,
      .lab_quantised = is_lab,
      .decides_cutouts = !is_lab,
      .light_sampling = options.integrator == IntegratorKind::Path ? options.light_sampling
                                                                   : LightSampling::Triangles,
      .keeps_media = options.integrator == IntegratorKind::Path,
      .samples_constant_sky = options.samples_constant_sky || !counts_met_light(options.sampling),
      .compensates_sky = options.compensates_sky && options.integrator == IntegratorKind::Path &&
                         options.sampling == SamplingStrategy::Mis,
      .light_cells = options.light_cells && options.integrator == IntegratorKind::Path,
      .opacity_grids = options.savings.opacity_grids};
}

}  // namespace candela
