#include "integrators/raster/raster_kernel.h"

#include "integrators/raster/trace_raster.h"
#include "integrators/whitted/lab_kernel.h"

namespace candela {

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

template Kernel raster_kernel(const Scene&, const EmbreeAccel&, const RenderOptions&);
template Kernel raster_kernel(const Scene&, const BvhAccel&, const RenderOptions&);

}  // namespace candela
