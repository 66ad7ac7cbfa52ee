#include "integrators/whitted/whitted_kernel.h"

#include "integrators/whitted/lab_kernel.h"
#include "integrators/whitted/trace_whitted.h"

namespace candela {

template <class A>
Kernel whitted_kernel(const Scene& scene, const A& accelerator, const RenderOptions& options) {
  LabRules rules{.specular = options.specular, .lab_normals = options.lab_normals};
  rules.max_depth = options.max_depth.value_or(rules.max_depth);
  return lab_kernel("whitted", lab_context(scene, accelerator, options, rules),
                    [](const LabContext<A>& context, const Ray& ray, TileCounts& counts) {
                      return trace_whitted(context, ray, counts);
                    });
}

template Kernel whitted_kernel(const Scene&, const EmbreeAccel&, const RenderOptions&);
template Kernel whitted_kernel(const Scene&, const BvhAccel&, const RenderOptions&);

}  // namespace candela
