#include "integrators/path/film_lanes.h"

#include <algorithm>
#include <limits>

#include "renderer/base/floating_point_traps.h"
#include "renderer/base/vector_widths.h"

namespace candela {
namespace {

CANDELA_LANES LaneMask find_lanes_within(float clamp, const Vec3Lanes& radiance) {
  const float most = std::min(clamp, std::numeric_limits<float>::max());
  LaneFlags flags;
  for (std::size_t i = 0; i < block_size; ++i)
    flags[i] = flag(radiance.x[i] >= 0) & flag(radiance.x[i] <= most) & flag(radiance.y[i] >= 0) &
               flag(radiance.y[i] <= most) & flag(radiance.z[i] >= 0) & flag(radiance.z[i] <= most);
  return mask_of(flags);
}

// Lanes whose radiance is valid and stays as it is.
LaneMask lanes_within(float clamp, const Vec3Lanes& radiance) {
  const FloatingPointTraps traps(Traps::Off);  // lanes that nothing is in, and what is invalid
  return find_lanes_within(clamp, radiance);
}

}  // namespace

void add_or_count(const BlockPlace& place, const Vec3Lanes& radiance, const Lanes<float>& weight,
                  const Lanes<float>& alpha, float clamp, Film& film, TileCounts& counts) {
  const int x = place.pixels.x[0];
  const int y = place.pixels.y[0];
  if ((place.lanes & ~lanes_within(clamp, radiance)) == 0)
    return film.add(x, y, place.samples[0], place.lanes, radiance, weight, alpha);
  for_each_lane(place.lanes, [&](std::uint32_t i) {
    FilmSample sample;
    sample.radiance = radiance[i];
    sample.weight = weight[i];
    sample.alpha = alpha[i];
    add_or_count(sample, x, y, place.samples[i], clamp, film, counts);
  });
}

}  // namespace candela
