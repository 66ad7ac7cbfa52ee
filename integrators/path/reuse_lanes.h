// What the paths of a block have to share (path_reuse.h), by lane, and the loops over lanes of it.
// Places are off their surfaces by their errors; shading and geometric normals are on the side that
// is seen, and the same where all are flat.
#pragma once

#include <span>

#include "integrators/path/shared_lobe.h"
#include "renderer/accel/ray_block.h"
#include "renderer/math/lanes.h"

namespace candela {

// LobeShape, and what it looks at.
struct LobeShapeLanes {
  void set(std::uint32_t i, const SurfaceCrossing& crossing) {
    if (crossing.shape == LobeShape::Schlick) schlick |= 1u << i;
    if (crossing.shape == LobeShape::Coat) coated |= 1u << i;
    coat[i] = crossing.coat;
    alpha[i] = crossing.alpha;
  }

  LaneMask schlick = 0, coated = 0;
  Lanes<const CoatTable*> coat{};
  Lanes<float> alpha{};

  [[nodiscard]] bool are_even() const { return (schlick | coated) == 0; }
};

// The first hits x, which light of others can reach.
struct FirstHitLanes {
  // Of the camera ray: its direction, the throughput that it ends with, and the number that picks
  // a lobe of what it met.
  Vec3Lanes camera, throughput;
  Lanes<float> lobe{};

  Vec3Lanes position, shading_normal, geometric_normal;
  bool are_flat = true;
  // The diffuse lobe (SharedLobe), with the throughput of the camera ray.
  Vec3Lanes even, shaped;
  LobeShapeLanes shapes;
  Lanes<float> probability{};  // with which directions are drawn from it
  Lanes<float> largest{};      // of its channels, where light arrives straight on
  LaneMask drawn = 0;          // the path's own is
  // The throughput of the path's own direction: by the diffuse lobe, and by the others.
  Vec3Lanes diffuse, glossy;
};

// The points y that paths met next.
struct SharedPointLanes {
  Vec3Lanes position, shading_normal, geometric_normal;
  Lanes<float> between{};  // the cosine between both
  bool are_flat = true;
  // How the diffuse lobe sends light to others, (even + shaped * shape(cosine)), and to x.
  Vec3Lanes even, shaped, towards_x;
  LobeShapeLanes shapes;
  // Where y is glossy: from where it is met, and what came straight from the light that is sampled
  // at every hit.
  LaneMask glossy = 0;
  Vec3Lanes wo, always;
  // By how much a first hit scales what the path brings from y on, in its largest channel: its own,
  // or all that y is shared with. Roulette goes by it.
  Lanes<float> importance{};
  // Of the path's radiance: up to y; straight from lights to y, by the diffuse lobe and by the
  // others; and which share of what it brings from y on is by the diffuse lobe.
  Vec3Lanes before, direct, direct_glossy, onward;
};

struct ReuseLanes {
  LaneMask receives = 0;  // whose x can be reached by others' light
  LaneMask apart = 0;  // whose path met a point y that can be shared: what it brings is kept apart
  LaneMask gives = 0;  // and serves others
  FirstHitLanes x;
  SharedPointLanes y;
  Vec3Lanes gain;  // what comes to x from all points, less what comes from the path's own
};

// From the first hits of a block to the points of another.
struct SegmentLanes {
  Lanes<float> cos_x{}, cos_y{};  // of shading normals
  Lanes<float> density{};         // see connect()
};

// Segments from the first hits of `at` to the points of `from`, and the densities with which cosine
// lobes at x find y if nothing is between them, per area and times pi. Returns the lanes in which
// they may, of those asked for; in others the density is 0.
[[nodiscard]] LaneMask connect(const ReuseLanes& at, const ReuseLanes& from, LaneMask lanes,
                               RayBlock& rays, SegmentLanes& segments);

// By what else than the cosine lobes count light.
[[nodiscard]] Lanes<float> shapes_at(const LobeShapeLanes& shapes, LaneMask lanes,
                                     const Lanes<float>& cosines);

// Densities at first hits become the weights of the balance heuristic [Veach97, section 9.2], over
// the lobes' probabilities: `seen` says of each in which lanes the segment is clear.
void weigh(std::span<SegmentLanes> segments, std::span<const LaneMask> seen,
           std::span<const ReuseLanes> at);

// How much points weigh for first hits, summed over these: `segments` of weights.
[[nodiscard]] Lanes<float> importance_of(std::span<const SegmentLanes> segments,
                                         std::span<const ReuseLanes> at);

// sum += weight * radiance.
void add_weighted(const Lanes<float>& weight, const Vec3Lanes& radiance, Vec3Lanes& sum);

// sum += weight * shape * radiance.
void add_shaped(const Lanes<float>& weight, const Lanes<float>& shape, const Vec3Lanes& radiance,
                Vec3Lanes& sum);

}  // namespace candela
