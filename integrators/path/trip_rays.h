// The rays of the blocks of a convoy: block by block; or, where what a ray is told depends on none
// that are asked for with it, so that blocks are full however few paths of each are on their way.
#pragma once

#include "integrators/path/trace_block.h"

namespace candela {

// Blocks of at least so many rays are traced as they are.
inline constexpr std::uint32_t fewest_alone = 12;

template <FeatureSet F, class A>
class TripRays {
 public:
  // Where the rays of the paths that are alive end.
  void add_rays(BlockTrip<A>& trip) {
    const RayBlock& rays = trip.block.rays;
    if (trip.bounce == 0 || !shares(trip, trip.alive)) {
      trip.block.hits = intersect_lanes(trip.context.accelerator, rays, trip.alive, trip.bounce);
      return;
    }
    trip.block.hits.met = 0;  // what other lanes hold means nothing
    trip.block.hits.instanced = 0;
    for_each_lane(trip.alive, [&](std::uint32_t lane) {
      put(trip, lane, rays);
      if (size_ == block_size) end_rays();
    });
  }
  void end_rays() {
    if (size_ == 0) return;
    const HitBlock hits = accelerator().intersect(rays_, filled(), Coherence::Incoherent);
    for (std::uint32_t k = 0; k < size_; ++k)
      places_[k].trip->block.hits.set(places_[k].lane, hits[k]);
    size_ = 0;
  }

  // Which of the shadow rays arrive.
  void add_shadow_rays(BlockTrip<A>& trip) {
    LanesAfterStep& after = trip.after;
    if (after.shadow_rays == 0) return;
    if (!shares(trip, after.shadow_rays)) {
      after.arriving = trace_shadow_rays<F>(trip, after.shadow_rays);
      return;
    }
    trip.count_shadow_rays(after.shadow_rays);
    for_each_lane(after.shadow_rays, [&](std::uint32_t lane) {
      put(trip, lane, trip.block.shadow_rays);
      if (size_ == block_size) end_shadow_rays();
    });
  }
  void end_shadow_rays() {
    if (size_ == 0) return;
    for_each_lane(filled() & ~accelerator().occluded(rays_, filled()), [&](std::uint32_t k) {
      places_[k].trip->after.arriving |= 1u << places_[k].lane;
    });
    size_ = 0;
  }

 private:
  [[nodiscard]] static bool shares(const BlockTrip<A>& trip, LaneMask lanes) {
    if constexpr (F.lanes && !F.media)
      return lane_count(lanes) < fewest_alone && trip.context.accelerator.allows_any_company();
    else
      return false;
  }
  [[nodiscard]] const A& accelerator() const { return places_[0].trip->context.accelerator; }
  [[nodiscard]] LaneMask filled() const { return (1u << size_) - 1; }
  void put(BlockTrip<A>& trip, std::uint32_t lane, const RayBlock& rays) {
    rays_.set(size_, rays[lane]);
    places_[size_++] = {&trip, lane};
  }

  struct Place {
    BlockTrip<A>* trip;
    std::uint32_t lane;
  };
  std::array<Place, block_size> places_{};
  std::uint32_t size_ = 0;
  RayBlock rays_;
};

}  // namespace candela
