// The kernels of whitted and raster.
#pragma once

#include "integrators/kernel.h"
#include "integrators/render_options.h"
#include "renderer/accel/any_accel.h"
#include "renderer/scene/scene.h"

namespace candela {

// What refers to the arguments lives as long as they do.
template <class A>
[[nodiscard]] Kernel whitted_kernel(const Scene& scene, const A& accelerator,
                                    const RenderOptions& options);
template <class A>
[[nodiscard]] Kernel raster_kernel(const Scene& scene, const A& accelerator,
                                   const RenderOptions& options);

extern template Kernel whitted_kernel(const Scene&, const EmbreeAccel&, const RenderOptions&);
extern template Kernel whitted_kernel(const Scene&, const BvhAccel&, const RenderOptions&);
extern template Kernel raster_kernel(const Scene&, const EmbreeAccel&, const RenderOptions&);
extern template Kernel raster_kernel(const Scene&, const BvhAccel&, const RenderOptions&);

}  // namespace candela
