// What every path of a render reads.
#pragma once

#include <cstdint>
#include <limits>

#include "integrators/render_options.h"
#include "integrators/tile_counts.h"
#include "renderer/camera/camera.h"
#include "renderer/film/film.h"
#include "renderer/film/filter.h"
#include "renderer/sampling/sampler.h"
#include "renderer/scene/scene.h"

namespace candela {

class BackgroundPixels;
class LampPixels;
class GuidingField;
class PathObserver;

template <class A>
struct PathContext {
  const Scene& scene;
  const A& accelerator;
  const Camera& camera;
  const Filter& filter;
  const RenderOptions& options;
  std::uint32_t max_depth;                       // the largest number where there is no limit
  const BackgroundPixels* background = nullptr;  // null: of no pixel it is known
  const LampPixels* lamps = nullptr;             // null: there are none
  Roulette roulette{};                           // of the pass (path_plan.h)
  // Of the pixel: camera rays a sample that look for lamps, and where; 0: the path's own does.
  std::uint32_t lamp_rays = 0;
  FilterPart lamp_part{};
  // Of the pass, for kernels with guiding and those that are observed(); null: there is none.
  const GuidingField* guide = nullptr;
  PathObserver* observer = nullptr;
};

template <class A>
[[nodiscard]] PathContext<A> make_path_context(const Scene& scene, const A& accelerator,
                                               const Filter& filter, const RenderOptions& options) {
  const std::uint32_t max_depth = options.max_depth ? static_cast<std::uint32_t>(*options.max_depth)
                                                    : std::numeric_limits<std::uint32_t>::max();
  return {scene, accelerator, scene.cameras[options.camera], filter, options, max_depth};
}

}  // namespace candela
