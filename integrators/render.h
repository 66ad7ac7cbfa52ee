// Scene + accelerator -> film. The fourth of the five doors.
#pragma once

#include <optional>
#include <string>

#include "integrators/render_options.h"
#include "integrators/render_statistics.h"
#include "renderer/accel/any_accel.h"
#include "renderer/base/diagnostic.h"
#include "renderer/base/progress.h"
#include "renderer/description/scene_description.h"
#include "renderer/film/error_estimate.h"
#include "renderer/film/film.h"
#include "renderer/scene/scene.h"

namespace candela {

struct RenderResult {
  Film film;
  RenderStatistics statistics;
  // None where some pixel has no two replicates, or where no sample has met light though the scene
  // has some.
  std::optional<ErrorEstimate> error;
};

// Runs on the current arena's threads (base/parallel.h: with_threads). `progress` and `cancel` may
// be null. When `cancel` becomes true the running tiles end and the film so far is returned.
// Throws std::invalid_argument for options that check_options() (check_options.h) refuses.
[[nodiscard]] RenderResult render(const Scene& scene, const AnyAccelerator& accelerator,
                                  const RenderOptions& options, ProgressSink* progress,
                                  const CancelFlag* cancel);

// What the options' integrator and strategy cannot draw of a scene: errors that a caller should
// heed, since render() leaves such lights and surfaces black.
[[nodiscard]] Diagnostics check_integrator(const description::SceneDescription& scene,
                                           const RenderOptions& options);

// Whether there is any light; for whitted and raster of the kinds that they know.
[[nodiscard]] bool has_light(const Scene& scene, const RenderOptions& options);

// The name of the kernel that render() would run with Embree, unless it guides paths.
[[nodiscard]] std::string kernel_name(const Scene& scene, const RenderOptions& options);

}  // namespace candela
