#include "integrators/path/camera_rays.h"

#include "renderer/base/vector_widths.h"

namespace candela {
namespace {

// By value: stores to the rays cannot change the camera.
CANDELA_LANES void aim_pinhole(Camera camera, const PixelLanes& pixels, const PlaceLanes& places,
                               RayBlock& rays) {
  for (std::size_t i = 0; i < block_size; ++i)
    rays.set(i, camera.pinhole_ray(pixels[i].on_film(places[i])));
}

CANDELA_LANES LaneMask traceable_lanes(const RayBlock& rays) {
  LaneFlags flags;
  for (std::size_t i = 0; i < block_size; ++i) flags[i] = is_traceable(rays[i]) ? 1 : 0;
  return mask_of(flags);
}

}  // namespace

CANDELA_LANES PlaceLanes sample_places(const Filter& filter, FilterPart part,
                                       const CameraNumbers& numbers) {
  PlaceLanes places;
  for (std::size_t i = 0; i < block_size; ++i) {
    Vec2f place = filter.sample(part.number(unit_point(numbers.filter, i)));
    places.x[i] = place.x;
    places.y[i] = place.y;
  }
  return places;
}

LaneMask aim_camera_rays(const Camera& camera, const PixelLanes& pixels, const PlaceLanes& places,
                         const CameraNumbers& numbers, LaneMask lanes, RayBlock& rays) {
  if (camera.is_pinhole())
    aim_pinhole(camera, pixels, places, rays);
  else
    for_each_lane(lanes, [&](std::uint32_t i) {
      rays.set(i, camera.generate_ray(pixels[i].on_film(places[i]), unit_point(numbers.lens, i)));
    });
  return lanes & traceable_lanes(rays);
}

}  // namespace candela
