// Camera rays of samples, at places that the filter chose (filter importance sampling).
#pragma once

#include "integrators/path/block_numbers.h"
#include "integrators/path/context.h"

namespace candela {

// A pixel of a picture.
struct PictureCell {
  int x;
  int y;
  int width;  // of the picture
  int height;

  // In [0,1]^2 over the picture where a place relative to the pixel's centre lies.
  [[nodiscard]] Vec2f on_film(Vec2f place) const {
    return {(static_cast<float>(x) + 0.5f + place.x) / static_cast<float>(width),
            (static_cast<float>(y) + 0.5f + place.y) / static_cast<float>(height)};
  }
};

// Those of a block's samples.
struct PixelLanes {
  Lanes<int> x{}, y{};
  int width;  // of the picture
  int height;

  [[nodiscard]] PictureCell operator[](std::size_t i) const { return {x[i], y[i], width, height}; }
};

struct PlaceLanes {
  Lanes<float> x, y;

  [[nodiscard]] Vec2f operator[](std::size_t i) const { return {x[i], y[i]}; }
};

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

[[nodiscard]] inline PixelLanes pixel_lanes_of(const RenderOptions& options) {
  return {{}, {}, options.width, options.height};
}

template <class A>
[[nodiscard]] inline PictureCell cell_of(const PathContext<A>& context, int x, int y) {
  return {x, y, context.options.width, context.options.height};
}

// Places relative to the pixels' centres, in a part of the filter.
[[nodiscard]] PlaceLanes sample_places(const Filter& filter, FilterPart part,
                                       const CameraNumbers& numbers);

// The rays through them: the same bits as Camera::generate_ray()'s. Returns which of `lanes` can be
// traced; of other lanes the rays mean nothing.
[[nodiscard]] LaneMask aim_camera_rays(const Camera& camera, const PixelLanes& pixels,
                                       const PlaceLanes& places, const CameraNumbers& numbers,
                                       LaneMask lanes, RayBlock& rays);

}  // namespace candela
