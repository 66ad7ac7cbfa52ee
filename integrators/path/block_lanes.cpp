#include "integrators/path/block_lanes.h"

#include "renderer/base/vector_widths.h"

namespace candela {
namespace {

template <class T>
inline void copy_lanes(const Lanes<T>& from, const LaneFlags& flags, Lanes<T>& to) {
  for (std::size_t i = 0; i < block_size; ++i) to[i] = flags[i] != 0 ? from[i] : to[i];
}
inline void copy_lanes(const Vec3Lanes& from, const LaneFlags& flags, Vec3Lanes& to) {
  copy_lanes(from.x, flags, to.x);
  copy_lanes(from.y, flags, to.y);
  copy_lanes(from.z, flags, to.z);
}
inline void fill_lanes(float value, const LaneFlags& flags, Lanes<float>& to) {
  for (std::size_t i = 0; i < block_size; ++i) to[i] = flags[i] != 0 ? value : to[i];
}

inline void copy_numbers(const Lanes<std::uint32_t>& from, Lanes<float>& to) {
  for (std::size_t i = 0; i < block_size; ++i) to[i] = unit_float(from[i]);
}

}  // namespace

CANDELA_LANES void begin_paths(PathLanes& paths) {
  for (std::size_t i = 0; i < block_size; ++i) paths.set(i, PathState{});
}

CANDELA_LANES void put_paths(const PathBlock& block, const BlockNumbers& numbers,
                             std::uint32_t bounce, LaneMask lanes, PlainLanes& plain) {
  const LaneFlags flags = flags_of(lanes);
  MetLanes& met = plain.met;
  copy_lanes(block.hits.geometry, flags, met.geometry);
  copy_lanes(block.hits.triangle, flags, met.triangle);
  copy_lanes(block.hits.u, flags, met.u);
  copy_lanes(block.hits.v, flags, met.v);
  copy_lanes(block.rays.direction, flags, met.direction);
  copy_lanes(block.paths.throughput, flags, met.throughput);
  copy_lanes(block.paths.roulette_scale, flags, met.roulette_scale);
  ScatteredLanes& scattered = plain.scattered;
  scattered.bounce.fill(bounce);
  copy_numbers(numbers.lobe(), scattered.lobe);
  copy_numbers(numbers.direction().x, scattered.direction_x);
  copy_numbers(numbers.direction().y, scattered.direction_y);
  copy_numbers(numbers.roulette(), scattered.roulette);
  plain.filled = lanes;
}

CANDELA_LANES void take_shadow_rays(const LightSampleLanes& samples, LaneMask lanes,
                                    PathBlock& block) {
  const LaneFlags flags = flags_of(lanes);
  copy_lanes(samples.shadow_origin, flags, block.shadow_rays.origin);
  copy_lanes(samples.shadow_direction, flags, block.shadow_rays.direction);
  copy_lanes(samples.shadow_end, flags, block.shadow_rays.t_max);
  copy_lanes(samples.contribution, flags, block.unshadowed);
}

CANDELA_LANES void take_scattered(const PlainLanes& plain, LaneMask lanes, PathBlock& block) {
  const LaneFlags flags = flags_of(lanes);
  const ScatteredLanes& scattered = plain.scattered;
  copy_lanes(scattered.throughput, flags, block.paths.throughput);
  copy_lanes(scattered.pdf, flags, block.paths.bsdf_pdf);
  copy_lanes(plain.met.shading_normal, flags, block.paths.receiving_normal);
  for (std::size_t i = 0; i < block_size; ++i) block.paths.is_delta[i] &= flags[i] ^ 1;
  copy_lanes(scattered.origin, flags, block.rays.origin);
  copy_lanes(scattered.direction, flags, block.rays.direction);
  fill_lanes(infinity, flags, block.rays.t_max);
}

CANDELA_LANES void add_unshadowed(LaneMask lanes, PathBlock& block) {
  const LaneFlags flags = flags_of(lanes);
  Vec3Lanes& radiance = block.paths.radiance;
  for (std::size_t i = 0; i < block_size; ++i) {
    Vec3f sum = radiance[i] + block.unshadowed[i];
    radiance.set(i, flags[i] != 0 ? sum : radiance[i]);
  }
}

}  // namespace candela
