// A kernel of whitted or raster, from what traces a camera sample.
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "integrators/kernel.h"
#include "integrators/whitted/lab_lights.h"
#include "integrators/whitted/lab_surface.h"
#include "integrators/whitted/render_grid_tile.h"

namespace candela {

[[nodiscard]] inline bool may_be_hole(const Material& material) {
  return is_glass(material) || material.opacity.texture ||
         material.opacity.constant < lab_hole_below;
}

template <class A>
[[nodiscard]] LabContext<A> lab_context(const Scene& scene, const A& accelerator,
                                        const RenderOptions& options, const LabRules& rules) {
  return {scene,
          accelerator,
          scene.cameras[options.camera],
          options,
          rules,
          lab_lights(scene),
          std::any_of(scene.materials.begin(), scene.materials.end(), may_be_hole)};
}

// `trace`: (context, ray, counts) -> FilmSample.
template <class A, class Trace>
[[nodiscard]] Kernel lab_kernel(std::string name, LabContext<A> context, Trace trace) {
  return {std::move(name), [context = std::move(context), trace](const TilePass& pass, Film& film) {
            return render_grid_tile(context, trace, pass, film);
          }};
}

}  // namespace candela
