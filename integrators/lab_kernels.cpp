#include "integrators/lab_kernels.h"

#include <algorithm>
#include <string>
#include <utility>

#include "integrators/raster/trace_raster.h"
#include "integrators/whitted/lab_lights.h"
#include "integrators/whitted/render_grid_tile.h"
#include "integrators/whitted/trace_whitted.h"

namespace candela {
namespace {

bool may_be_hole(const Material& material) {
  return is_glass(material) || material.opacity.texture ||
         material.opacity.constant < lab_hole_below;
}

template <class A>
LabContext<A> lab_context(const Scene& scene, const A& accelerator, const RenderOptions& options,
                          const LabRules& rules) {
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
Kernel lab_kernel(std::string name, LabContext<A> context, Trace trace) {
  return {std::move(name), [context = std::move(context), trace](const TilePass& pass, Film& film) {
            return render_grid_tile(context, trace, pass, film);
          }};
}

}  // namespace

template <class A>
Kernel whitted_kernel(const Scene& scene, const A& accelerator, const RenderOptions& options) {
  LabRules rules{.specular = options.specular, .lab_normals = options.lab_normals};
  rules.max_depth = options.max_depth.value_or(rules.max_depth);
  return lab_kernel("whitted", lab_context(scene, accelerator, options, rules),
                    [](const LabContext<A>& context, const Ray& ray, TileCounts& counts) {
                      return trace_whitted(context, ray, counts);
                    });
}

template <class A>
Kernel raster_kernel(const Scene& scene, const A& accelerator, const RenderOptions& options) {
  const LabRules rules{.specular = options.specular,
                       .shadows = false,
                       .bump = true,
                       .lab_normals = options.lab_normals};
  return lab_kernel("raster", lab_context(scene, accelerator, options, rules),
                    [](const LabContext<A>& context, const Ray& ray, TileCounts& counts) {
                      return trace_raster(context, ray, counts);
                    });
}

template Kernel whitted_kernel(const Scene&, const EmbreeAccel&, const RenderOptions&);
template Kernel whitted_kernel(const Scene&, const BvhAccel&, const RenderOptions&);
template Kernel raster_kernel(const Scene&, const EmbreeAccel&, const RenderOptions&);
template Kernel raster_kernel(const Scene&, const BvhAccel&, const RenderOptions&);

}  // namespace candela
