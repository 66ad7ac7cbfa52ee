#include "integrators/render.h"

#include <functional>
#include <memory>
#include <stdexcept>

#include "integrators/background_pixels.h"
#include "integrators/check_media.h"
#include "integrators/check_options.h"
#include "integrators/feasible_options.h"
#include "integrators/kernel.h"
#include "integrators/lab_kernels.h"
#include "integrators/path/check_sampling.h"
#include "integrators/path/find_lamp_pixels.h"
#include "integrators/path/kernels.h"
#include "integrators/render_rounds.h"
#include "integrators/report/check_report.h"
#include "integrators/report/report_context.h"
#include "integrators/time_budget.h"
#include "integrators/whitted/lab_lights.h"

namespace candela {
namespace {

// The instance for the scene, or the one for comparisons of estimators.
template <class A>
PathKernel<A> path_instance(const Scene& scene, const RenderOptions& options) {
  if (!has_default_strategy(options)) return strategy_kernel<A>();
  return select_path_kernel<A>(scene.features, options.uses_general_kernel);
}

// For passes with a guide or an observer.
template <class A>
auto observed_kernel(const Scene& scene) {
  return scene.features.media ? &render_tile<media_features, A> : &render_tile<guided_features, A>;
}

bool sees_nothing(const BackgroundPixels& background, const PixelRect& rect) {
  if (background.is_empty() || !background.sample() || !is_black(background.sample()->radiance))
    return false;
  for (int y = rect.y0; y < rect.y1; ++y)
    for (int x = rect.x0; x < rect.x1; ++x)
      if (!background.contains(x, y)) return false;
  return true;
}

template <class A>
Kernel path_kernel(const Scene& scene, const A& accelerator, const Filter& filter,
                   const RenderOptions& options, const std::function<bool()>& is_over) {
  const PathKernel<A> kernel = path_instance<A>(scene, options);
  PathContext<A> context = make_path_context(scene, accelerator, filter, options);
  const auto lamps =
      std::make_shared<const LampPixels>(find_lamp_pixels<media_features>(context, is_over));
  context.lamps = lamps.get();
  // For the general kernel, too: which pixels share blocks must not depend on the kernel.
  const auto background = std::make_shared<const BackgroundPixels>(scene, filter, options);
  context.background = background.get();
  return {"path/" + std::string(kernel.name),
          [render = kernel.render, observed = observed_kernel<A>(scene), context, lamps,
           background](const TilePass& pass, Film& film) {
            const bool is_observed = pass.guide != nullptr || pass.observer != nullptr;
            return (is_observed ? observed : render)(context, pass, film);
          },
          sees_nothing(*background, rendered_rect(options))};
}

template <class A>
Kernel report_kernel(const Scene& scene, const A& accelerator, const Filter& filter,
                     const RenderOptions& options) {
  return {"report", [context = make_report_context(scene, accelerator, filter, options)](
                        const TilePass& pass, Film& film) {
            return render_report_tile(context, pass, film);
          }};
}

// What refers to its arguments lives as long as they do. `is_over`: asked now and then whether to
// leave out what takes time.
template <class A>
Kernel select_kernel(const Scene& scene, const A& accelerator, const Filter& filter,
                     const RenderOptions& options, const std::function<bool()>& is_over) {
  switch (options.integrator) {
    case IntegratorKind::Path:
      return path_kernel(scene, accelerator, filter, options, is_over);
    case IntegratorKind::Whitted:
      return whitted_kernel(scene, accelerator, options);
    case IntegratorKind::Raster:
      return raster_kernel(scene, accelerator, options);
    case IntegratorKind::Report:
      return report_kernel(scene, accelerator, filter, options);
  }
  throw std::invalid_argument("no such integrator");
}

}  // namespace

bool has_light(const Scene& scene, const RenderOptions& options) {
  if (is_lab_shading(options.integrator))
    return !is_black(scene.ambient) || !lab_lights(scene).empty();
  return !scene.lights.empty() || (scene.environment && !scene.environment->is_black());
}

RenderResult render(const Scene& scene, const AnyAccelerator& accelerator,
                    const RenderOptions& options, ProgressSink* progress,
                    const CancelFlag* cancel) {
  require_valid(scene, options);
  const TimeBudget::Clock::time_point start = TimeBudget::Clock::now();
  const Filter filter = make_filter(options);
  const RenderOptions rounds = feasible_options(scene, options);
  RenderResult result{Film(options.width, options.height, rendered_rect(options), options.aovs,
                           film_replicates(options), film_balance(options)),
                      {},
                      {}};
  const TimeBudget budget(options.time_limit_seconds, start);
  const auto is_over = [&] { return is_set(cancel) || budget.is_spent(preparation_share); };
  std::visit(
      [&](const auto& backend) {
        const Kernel kernel = select_kernel(scene, backend, filter, options, is_over);
        const RoundsDone done =
            render_rounds(rounds, kernel.render_tile, result.film, progress, cancel,
                          has_light(scene, options) && !kernel.sees_nothing, start);
        const TileCounts& counts = done.counts;
        result.statistics = {.rays = counts.rays,
                             .skipped = counts.skipped,
                             .invalid_samples = counts.invalid_samples,
                             .first_invalid = counts.first_invalid,
                             .kernel = done.guiding.cells > 0 ? "path/guided" : kernel.name,
                             .plan = done.plan,
                             .roulette_samples = done.roulette_samples,
                             .reuse_samples = done.reuse_samples,
                             .guiding = done.guiding,
                             .stop = done.stop};
        result.error = done.error;
      },
      accelerator);
  return result;
}

Diagnostics check_integrator(const description::SceneDescription& scene,
                             const RenderOptions& options) {
  switch (options.integrator) {
    case IntegratorKind::Path:
      return check_sampling(scene, options.sampling);
    case IntegratorKind::Report: {
      Diagnostics diagnostics = check_report(scene);
      diagnostics.append(check_media(scene, "report"));
      return diagnostics;
    }
    case IntegratorKind::Whitted:
      return check_media(scene, "whitted");
    case IntegratorKind::Raster:
      return check_media(scene, "raster");
  }
  return {};
}

std::string kernel_name(const Scene& scene, const RenderOptions& options) {
  switch (options.integrator) {
    case IntegratorKind::Path:
      return "path/" + std::string(path_instance<EmbreeAccel>(scene, options).name);
    case IntegratorKind::Whitted:
      return "whitted";
    case IntegratorKind::Raster:
      return "raster";
    case IntegratorKind::Report:
      return "report";
  }
  return "";
}

}  // namespace candela
