// What every path of a render reads, and what its tile counts.
#pragma once

#include <cstdint>
#include <limits>
#include <tuple>

#include "integrators/render.h"
#include "renderer/camera/camera.h"
#include "renderer/film/film.h"
#include "renderer/film/filter.h"
#include "renderer/sampling/sampler.h"
#include "renderer/scene/scene.h"

namespace candela {

template <class A>
struct PathContext {
  const Scene& scene;
  const A& accelerator;
  const Camera& camera;
  const Filter& filter;
  const RenderOptions& options;
  std::uint32_t max_depth;  // the largest number where there is no limit
};

template <class A>
[[nodiscard]] PathContext<A> make_path_context(const Scene& scene, const A& accelerator,
                                               const Filter& filter, const RenderOptions& options) {
  const std::uint32_t max_depth = options.max_depth ? static_cast<std::uint32_t>(*options.max_depth)
                                                    : std::numeric_limits<std::uint32_t>::max();
  return {scene, accelerator, scene.cameras[options.camera], filter, options, max_depth};
}

[[nodiscard]] inline Filter make_filter(const RenderOptions& options) {
  return {options.filter, options.filter_radius.value_or(default_radius(options.filter))};
}

[[nodiscard]] inline PixelRect rendered_rect(const RenderOptions& options) {
  return options.crop.value_or(PixelRect{0, 0, options.width, options.height});
}

// Summed over tiles at the end: no shared counters.
struct TileCounts {
  RayCounts rays;
  SkippedCounts skipped;
  std::uint64_t invalid_samples = 0;
  std::optional<InvalidSample> first_invalid;

  void add(const TileCounts& other) {
    rays.camera += other.rays.camera;
    rays.indirect += other.rays.indirect;
    rays.shadow += other.rays.shadow;
    skipped.shadow_rays += other.skipped.shadow_rays;
    invalid_samples += other.invalid_samples;
    const auto order = [](const InvalidSample& s) { return std::tuple(s.y, s.x, s.sample); };
    if (other.first_invalid &&
        (!first_invalid || order(*other.first_invalid) < order(*first_invalid)))
      first_invalid = other.first_invalid;
  }
};

}  // namespace candela
