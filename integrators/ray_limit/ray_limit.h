// How near a render comes to the rays alone.
#pragma once

#include <cstdint>
#include <optional>

#include "integrators/render_options.h"
#include "renderer/accel/any_accel.h"
#include "renderer/base/progress.h"
#include "renderer/scene/scene.h"

namespace candela {

// CPU seconds of rendering a fixed share of the tiles, against replaying their rays through bare
// backend calls (`--ray-limit`). For the path integrator only. Nothing where `cancel` (may be null)
// becomes true before the end.
struct RayLimit {
  double render_seconds = 0;
  double rays_seconds = 0;
  std::uint64_t rays = 0;
  [[nodiscard]] double ratio() const {
    return rays_seconds > 0 ? render_seconds / rays_seconds : 0;
  }
};
[[nodiscard]] std::optional<RayLimit> measure_ray_limit(const Scene& scene,
                                                        const AnyAccelerator& accelerator,
                                                        const RenderOptions& options,
                                                        const CancelFlag* cancel);

}  // namespace candela
