#include "integrators/path/reuse_lanes.h"

#include <cmath>

#include "renderer/base/vector_widths.h"
#include "renderer/geometry/surface_point.h"

namespace candela {

namespace {

struct Vectors {
  const Vec3Lanes& lanes;
  [[nodiscard]] float dot(std::size_t i, float x, float y, float z) const {
    return x * lanes.x[i] + y * lanes.y[i] + z * lanes.z[i];
  }
};

template <bool are_flat>
[[nodiscard]] inline LaneMask connect_lanes(const ReuseLanes& at, const ReuseLanes& from,
                                            LaneMask lanes, RayBlock& segments,
                                            Lanes<float>& density) {
  constexpr float before_end = 1 - 0x1p-20f;  // y itself is in nobody's way
  const LaneFlags flags = flags_of(lanes);
  LaneFlags found;
  segments.origin = at.x;
  for (std::size_t i = 0; i < block_size; ++i) {
    const float x = from.y.x[i] - at.x.x[i];
    const float y = from.y.y[i] - at.x.y[i];
    const float z = from.y.z[i] - at.x.z[i];
    const float length2 = x * x + y * y + z * z;
    const bool is_apart = (flags[i] != 0) & (length2 > 0);
    const float distance = std::sqrt(is_apart ? length2 : 1.0f);
    const float inverse = 1 / distance;
    segments.direction.x[i] = x * inverse;
    segments.direction.y[i] = y * inverse;
    segments.direction.z[i] = z * inverse;
    segments.t_max[i] = distance * before_end;
    const float cos_x = Vectors{at.x_shading}.dot(i, x, y, z) * inverse;
    const float cos_y = -Vectors{from.y_geometric}.dot(i, x, y, z) * inverse;
    bool is_found = is_apart & (cos_x > 0) & (cos_y > 0);
    if constexpr (!are_flat) {
      const float geometric_x = Vectors{at.x_geometric}.dot(i, x, y, z);
      const float shading_y = -Vectors{from.y_shading}.dot(i, x, y, z) * inverse;
      is_found = is_found & (geometric_x > 0) & is_unbent(shading_y, from.y_between[i], cos_y);
    }
    found[i] = is_found ? 1 : 0;
    density[i] = is_found ? cos_x * cos_y * inverse * inverse : 0.0f;
  }
  return mask_of(found);
}

CANDELA_LANES LaneMask connect_flat(const ReuseLanes& at, const ReuseLanes& from, LaneMask lanes,
                                    RayBlock& segments, Lanes<float>& density) {
  return connect_lanes<true>(at, from, lanes, segments, density);
}
CANDELA_LANES LaneMask connect_any(const ReuseLanes& at, const ReuseLanes& from, LaneMask lanes,
                                   RayBlock& segments, Lanes<float>& density) {
  return connect_lanes<false>(at, from, lanes, segments, density);
}

}  // namespace

LaneMask connect(const ReuseLanes& at, const ReuseLanes& from, LaneMask lanes, RayBlock& segments,
                 Lanes<float>& density) {
  if (at.is_x_flat && from.is_y_flat) return connect_flat(at, from, lanes, segments, density);
  return connect_any(at, from, lanes, segments, density);
}

CANDELA_LANES void weigh(std::span<Lanes<float>> densities, std::span<const LaneMask> seen) {
  Lanes<float> sum{};
  for (std::size_t k = 0; k < densities.size(); ++k) {
    const LaneFlags flags = flags_of(seen[k]);
    Lanes<float>& density = densities[k];
    for (std::size_t i = 0; i < block_size; ++i) {
      density[i] = flags[i] != 0 ? density[i] : 0.0f;
      sum[i] += density[i];
    }
  }
  for (std::size_t i = 0; i < block_size; ++i) sum[i] = sum[i] > 0 ? 1 / sum[i] : 0.0f;
  for (Lanes<float>& density : densities)
    for (std::size_t i = 0; i < block_size; ++i) density[i] *= sum[i];
}

CANDELA_LANES void add_weighted(const Lanes<float>& weight, const Vec3Lanes& radiance,
                                Vec3Lanes& sum) {
  for (std::size_t i = 0; i < block_size; ++i) {
    sum.x[i] += weight[i] * radiance.x[i];
    sum.y[i] += weight[i] * radiance.y[i];
    sum.z[i] += weight[i] * radiance.z[i];
  }
}

}  // namespace candela
