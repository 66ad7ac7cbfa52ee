// The rays of the blocks of a convoy: block by block, or gathered from several, so that blocks are
// full however few paths of each are on their way.
#pragma once

#include "integrators/path/gathered_rays.h"
#include "integrators/path/trace_block.h"

namespace candela {

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
      gathered_.add(rays[lane], {&trip, lane});
      if (gathered_.is_full()) end_rays();
    });
  }
  void end_rays() {
    if (gathered_.is_empty()) return;
    const HitBlock hits =
        accelerator().intersect(gathered_.rays(), gathered_.lanes(), Coherence::Incoherent);
    for_each_lane(gathered_.lanes(), [&](std::uint32_t k) {
      const auto& [trip, lane] = gathered_.place(k);
      trip->block.hits.set(lane, hits[k]);
    });
    gathered_.clear();
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
      gathered_.add(trip.block.shadow_rays[lane], {&trip, lane});
      if (gathered_.is_full()) end_shadow_rays();
    });
  }
  void end_shadow_rays() {
    if (gathered_.is_empty()) return;
    const LaneMask lanes = gathered_.lanes();
    for_each_lane(lanes & ~accelerator().occluded(gathered_.rays(), lanes), [&](std::uint32_t k) {
      const auto& [trip, lane] = gathered_.place(k);
      trip->after.arriving |= 1u << lane;
    });
    gathered_.clear();
  }

 private:
  [[nodiscard]] static bool shares(const BlockTrip<A>& trip, LaneMask lanes) {
    if constexpr (F.lanes && !F.media)
      return is_gathered(trip.context.accelerator, lanes);
    else
      return false;
  }
  [[nodiscard]] const A& accelerator() const {
    return gathered_.place(0).trip->context.accelerator;
  }

  struct Place {
    BlockTrip<A>* trip = nullptr;
    std::uint32_t lane = 0;
  };
  GatheredRays<Place> gathered_;
};

}  // namespace candela
