// The paths of a block on their way, by lane.
#pragma once

#include <array>

#include "integrators/path/path_step.h"
#include "renderer/accel/ray_block.h"

namespace candela {

// PathState, by lane.
struct PathLanes {
  [[nodiscard]] PathState operator[](std::size_t i) const {
    return {throughput[i],       radiance[i],      bsdf_pdf[i],  roulette_scale[i],
            receiving_normal[i], is_delta[i] != 0, light_cell[i]};
  }
  void set(std::size_t i, const PathState& path) {
    throughput.set(i, path.throughput);
    radiance.set(i, path.radiance);
    bsdf_pdf[i] = path.bsdf_pdf;
    roulette_scale[i] = path.roulette_scale;
    receiving_normal.set(i, path.receiving_normal);
    is_delta[i] = flag(path.is_delta);
    light_cell[i] = path.light_cell;
  }
  void add_radiance(std::size_t i, const Rgb& more) { radiance.set(i, radiance[i] + more); }

  Vec3Lanes throughput, radiance;
  Lanes<float> bsdf_pdf{}, roulette_scale{};
  Vec3Lanes receiving_normal;
  LaneFlags is_delta{};
  Lanes<std::uint32_t> light_cell{};  // set where lights were picked
};

// Where paths are split: where they all come from, and what those that have ended brought.
struct SplitPaths {
  RayBlock camera_rays;
  HitBlock hits;
  Vec3Lanes radiance;
};

// Which lanes of a block have a shadow ray after a step, and which a ray to go on with.
struct LanesAfterStep {
  LaneMask shadow_rays = 0;
  LaneMask sky_rays = 0;  // of the shadow rays those whose contribution lacks the sky
  LaneMask arriving = 0;  // of the shadow rays those that bring something, once they are traced
  LaneMask going_on = 0;
};

struct PathBlock {
  RayBlock rays;
  HitBlock hits;  // of the rays
  PathLanes paths;
  RayBlock shadow_rays;
  Vec3Lanes unshadowed;  // what the shadow rays bring if nothing is in their way
  // Of the film's samples: the filter's weight, alpha, and where there are layers what those keep.
  Lanes<float> weight, alpha;
  std::array<FilmSample, block_size> first_hits;
  SplitPaths split;
  // Kernels with media only: around the paths, and where the shadow rays start.
  std::array<MediumHandle, block_size> media;
  std::array<MediumHandle, block_size> shadow_media;
};

// Of the paths those that are in no medium.
template <FeatureSet F>
[[nodiscard]] inline LaneMask lanes_without_medium(const PathBlock& block, LaneMask lanes) {
  if constexpr (!F.media) return lanes;
  LaneMask within = 0;
  for_each_lane(lanes, [&](std::uint32_t i) { within |= flag(block.media[i].is_valid()) << i; });
  return lanes & ~within;
}

// The next ray of a path cannot be traced, which makes the sample invalid.
inline void lose_path(PathBlock& block, std::uint32_t i) {
  block.paths.radiance.set(i, invalid_radiance);
}
// The next ray of a path; false where it cannot be traced.
[[nodiscard]] inline bool set_ray(PathBlock& block, std::uint32_t i, const Ray& ray) {
  block.rays.set(i, ray);
  if (is_traceable(ray)) return true;
  lose_path(block, i);
  return false;
}

// Of a block's rays: those from the camera leave side by side.
[[nodiscard]] inline Coherence coherence_of(std::uint32_t bounce) {
  return bounce == 0 ? Coherence::Coherent : Coherence::Incoherent;
}

}  // namespace candela
