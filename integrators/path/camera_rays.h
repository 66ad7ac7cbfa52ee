// Camera rays of the samples of a pixel.
#pragma once

#include "integrators/path/block_numbers.h"
#include "integrators/path/context.h"

namespace candela {

// Of one sample at a place that the filter chose (filter importance sampling).
template <class A>
[[nodiscard]] inline Ray camera_ray(const PathContext<A>& context, Vec2f place, Vec2f lens, int x,
                                    int y) {
  Vec2f film{(static_cast<float>(x) + 0.5f + place.x) / static_cast<float>(context.options.width),
             (static_cast<float>(y) + 0.5f + place.y) / static_cast<float>(context.options.height)};
  return context.camera.generate_ray(film, lens);
}

// The numbers of camera rays.
struct CameraNumbers {
  SobolPointLanes filter;
  SobolPointLanes lens{};

  void draw(const Camera& camera, const SamplerBlock& samplers, Dimension of_filter,
            Dimension of_lens) {
    samplers.sample_2d(0, of_filter, filter);
    if (camera.lens_radius > 0) samplers.sample_2d(0, of_lens, lens);
  }
};

}  // namespace candela
