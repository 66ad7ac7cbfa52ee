#include "integrators/feasible_options.h"

#include "integrators/path/shared_surfaces.h"

namespace candela {
namespace {

// Whether what lies clear between two surfaces that bound no media may be within one all the same.
bool may_see_through_media(const SceneFeatures& features) {
  return features.cameras_in_media || features.clear_boundaries;
}

// Paths of which pixels can share what they find (path/path_reuse.h).
bool may_reuse_paths(const Scene& scene, const RenderOptions& options) {
  if (options.integrator != IntegratorKind::Path || !has_default_strategy(options) ||
      options.plan.splitting > 1 || options.guiding != Guiding::Off ||
      may_see_through_media(scene.features) || options.max_depth.value_or(2) < 2)
    return false;
  for (std::uint32_t i = 0; i < scene.geometries.size(); ++i)
    if (gives_shared(scene, i)) return true;
  return false;
}

}  // namespace

RenderOptions feasible_options(const Scene& scene, const RenderOptions& options) {
  RenderOptions done = options;
  if (!has_default_strategy(options)) done.guiding = Guiding::Off;
  if (scene.features.media) {  // branches.h
    done.guiding = Guiding::Off;
    done.plan.splitting = 1;
  }
  const bool may_reuse = may_reuse_paths(scene, done);
  done.plan.reuses_paths = options.plan.reuses_paths && may_reuse;
  done.chooses_reuse = options.chooses_reuse && may_reuse;
  done.adaptive = options.adaptive && options.integrator == IntegratorKind::Path;
  done.chooses_roulette = options.chooses_roulette && options.integrator == IntegratorKind::Path &&
                          done.plan.splitting == 1 && done.guiding == Guiding::Off &&
                          has_default_strategy(options);
  return done;
}

}  // namespace candela
