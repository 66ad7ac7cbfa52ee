#include "integrators/path/sky_samples.h"

#include "integrators/path/film_lanes.h"
#include "integrators/path/sky_lanes.h"

namespace candela {

void add_sky_samples(const Scene& scene, const Filter& filter, const RenderOptions& options,
                     const PixelSampler& pixel, const SampleRange& range, int x, int y, Film& film,
                     TileCounts& counts) {
  const Camera& camera = scene.cameras[options.camera];
  RayBlock rays;
  Vec3Lanes radiance;
  Lanes<float> weight, alpha;
  weight.fill(1);
  alpha.fill(0);
  for (std::uint32_t base = first_block(range); base < range.end; base += block_size) {
    const BlockPlace place = place_in_pixel(options, x, y, base, lanes_in(base, range));
    CameraNumbers numbers;
    numbers.draw(camera, SamplerBlock(pixel, base), Dimension::Filter, Dimension::Lens);
    const LaneMask aimed = aim_camera_rays(camera, place.pixels, sample_places(filter, {}, numbers),
                                           numbers, place.lanes, rays);
    find_sky_radiance(*scene.environment, scene.textures, aimed, rays.direction,
                      Coherence::Coherent, radiance);
    for_each_lane(place.lanes & ~aimed,
                  [&](std::uint32_t i) { radiance.set(i, invalid_radiance); });
    add_or_count(place, radiance, weight, alpha, options.clamp, film, counts);
  }
}

}  // namespace candela
