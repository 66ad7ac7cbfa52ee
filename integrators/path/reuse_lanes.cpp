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
[[nodiscard]] inline LaneMask connect_lanes(const FirstHitLanes& at, const SharedPointLanes& from,
                                            LaneMask lanes, RayBlock& rays,
                                            SegmentLanes& segments) {
  constexpr float before_end = 1 - 0x1p-20f;  // y itself is in nobody's way
  const LaneFlags flags = flags_of(lanes);
  LaneFlags found;
  rays.origin = at.position;
  for (std::size_t i = 0; i < block_size; ++i) {
    const float x = from.position.x[i] - at.position.x[i];
    const float y = from.position.y[i] - at.position.y[i];
    const float z = from.position.z[i] - at.position.z[i];
    const float length2 = x * x + y * y + z * z;
    const bool is_apart = (flags[i] != 0) & (length2 > 0);
    const float distance = std::sqrt(is_apart ? length2 : 1.0f);
    const float inverse = 1 / distance;
    rays.direction.x[i] = x * inverse;
    rays.direction.y[i] = y * inverse;
    rays.direction.z[i] = z * inverse;
    rays.t_max[i] = distance * before_end;
    const float cos_x = Vectors{at.shading_normal}.dot(i, x, y, z) * inverse;
    const float cos_y = -Vectors{from.geometric_normal}.dot(i, x, y, z) * inverse;
    float shading_y = cos_y;
    bool is_found = is_apart & (cos_x > 0) & (cos_y > 0);
    if constexpr (!are_flat) {
      const float geometric_x = Vectors{at.geometric_normal}.dot(i, x, y, z);
      shading_y = -Vectors{from.shading_normal}.dot(i, x, y, z) * inverse;
      is_found = is_found & (geometric_x > 0) & is_unbent(shading_y, from.between[i], cos_y);
    }
    found[i] = is_found ? 1 : 0;
    segments.cos_x[i] = cos_x;
    segments.cos_y[i] = shading_y;
    segments.density[i] = is_found ? cos_x * cos_y * inverse * inverse : 0.0f;
  }
  return mask_of(found);
}

CANDELA_LANES LaneMask connect_flat(const FirstHitLanes& at, const SharedPointLanes& from,
                                    LaneMask lanes, RayBlock& rays, SegmentLanes& segments) {
  return connect_lanes<true>(at, from, lanes, rays, segments);
}
CANDELA_LANES LaneMask connect_any(const FirstHitLanes& at, const SharedPointLanes& from,
                                   LaneMask lanes, RayBlock& rays, SegmentLanes& segments) {
  return connect_lanes<false>(at, from, lanes, rays, segments);
}

CANDELA_LANES Lanes<float> schlick_weights(const Lanes<float>& cosines) {
  Lanes<float> weights;
  for (std::size_t i = 0; i < block_size; ++i) weights[i] = schlick_weight(cosines[i]);
  return weights;
}

}  // namespace

LaneMask connect(const ReuseLanes& at, const ReuseLanes& from, LaneMask lanes, RayBlock& rays,
                 SegmentLanes& segments) {
  if (at.x.are_flat && from.y.are_flat) return connect_flat(at.x, from.y, lanes, rays, segments);
  return connect_any(at.x, from.y, lanes, rays, segments);
}

Lanes<float> shapes_at(const LobeShapeLanes& shapes, LaneMask lanes, const Lanes<float>& cosines) {
  Lanes<float> at{};
  if ((shapes.schlick & lanes) != 0) at = schlick_weights(cosines);
  for_each_lane(shapes.coated & lanes, [&](std::uint32_t i) {
    at[i] = shapes.coat[i]->transmittance(cosines[i], shapes.alpha[i]);
  });
  return at;
}

CANDELA_LANES void weigh(std::span<SegmentLanes> segments, std::span<const LaneMask> seen,
                         std::span<const ReuseLanes> at) {
  Lanes<float> sum{};
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const LaneFlags flags = flags_of(seen[k]);
    Lanes<float>& density = segments[k].density;
    for (std::size_t i = 0; i < block_size; ++i) {
      density[i] = flags[i] != 0 ? density[i] : 0.0f;
      sum[i] += density[i] * at[k].x.probability[i];
    }
  }
  for (std::size_t i = 0; i < block_size; ++i) sum[i] = sum[i] > 0 ? 1 / sum[i] : 0.0f;
  for (SegmentLanes& segment : segments)
    for (std::size_t i = 0; i < block_size; ++i) segment.density[i] *= sum[i];
}

CANDELA_LANES Lanes<float> importance_of(std::span<const SegmentLanes> segments,
                                         std::span<const ReuseLanes> at) {
  Lanes<float> sum{};
  for (std::size_t k = 0; k < segments.size(); ++k)
    for (std::size_t i = 0; i < block_size; ++i)
      sum[i] += segments[k].density[i] * at[k].x.largest[i];
  return sum;
}

CANDELA_LANES void add_weighted(const Lanes<float>& weight, const Vec3Lanes& radiance,
                                Vec3Lanes& sum) {
  for (std::size_t i = 0; i < block_size; ++i) {
    sum.x[i] += weight[i] * radiance.x[i];
    sum.y[i] += weight[i] * radiance.y[i];
    sum.z[i] += weight[i] * radiance.z[i];
  }
}

CANDELA_LANES void add_shaped(const Lanes<float>& weight, const Lanes<float>& shape,
                              const Vec3Lanes& radiance, Vec3Lanes& sum) {
  for (std::size_t i = 0; i < block_size; ++i) {
    const float shaped = weight[i] * shape[i];
    sum.x[i] += shaped * radiance.x[i];
    sum.y[i] += shaped * radiance.y[i];
    sum.z[i] += shaped * radiance.z[i];
  }
}

}  // namespace candela
