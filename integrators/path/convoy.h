// Blocks of samples that travel together: the fewer paths of each are still on their way, the more
// there are of others to take steps with. No path's bits depend on which.
#pragma once

#include <array>
#include <optional>

#include "integrators/path/path_reuse.h"
#include "integrators/path/step_plain_lanes.h"
#include "integrators/path/trip_rays.h"

namespace candela {

template <FeatureSet F, class A>
class Convoy {
 public:
  static constexpr std::size_t capacity = F.lanes || F.reuses_paths() ? 16 : 1;  // blocks

  explicit Convoy(bool is_together = true) : most_(is_together && F.lanes ? capacity : 1) {}

  [[nodiscard]] bool is_full() const { return size_ == most_; }
  // Of a group, which travels together whatever the convoy was told.
  [[nodiscard]] bool has_room_for(std::size_t blocks) const { return size_ + blocks <= capacity; }

  // The next block, whose paths are to be started.
  template <class... Arguments>
  BlockTrip<A>& add(const Arguments&... arguments) {
    const std::size_t i = size_++;
    return trips_[i].emplace(arguments..., blocks_[i]);
  }

  // The blocks since the last group are one.
  void end_group() {
    if (!reuse_) reuse_.emplace();
    reuse_->end_group(size_);
  }

  // From the camera rays to the paths' radiances.
  void travel() {
    for_each_trip([](BlockTrip<A>& trip) {
      if (trip.branches.is_split()) trip.branches.begin(trip.alive, trip.block);
    });
    for (bounces_ = 0; travel_to_next_bounce(); ++bounces_) {
    }
    if constexpr (F.reuses_paths()) {
      if (has_groups() && bounces_ > 1) reuse_->gather(trips_);
    }
    for_each_trip([](BlockTrip<A>& trip) {
      if (trip.branches.is_split()) trip.branches.end(trip.block);
    });
  }

  // Calls visit(trip) in the order of their being added.
  template <class Visit>
  void for_each_trip(const Visit& visit) {
    for (std::size_t i = 0; i < size_; ++i) visit(*trips_[i]);
  }

  // Where all blocks are of groups. Calls visit(trip, gain): by how much sharing makes its samples
  // larger (path_reuse.h).
  template <class Visit>
  void for_each_gain(const Visit& visit) {
    for (std::size_t i = 0; i < size_; ++i) visit(*trips_[i], reuse_->gain(i));
  }

  void clear() {
    size_ = 0;
    if (reuse_) reuse_->clear();
  }

 private:
  // False where no path is on its way any more.
  [[nodiscard]] bool travel_to_next_bounce() {
    std::array<bool, capacity> moves{};
    bool any_moves = false;
    for (std::size_t i = 0; i < size_; ++i) {
      moves[i] = trips_[i]->alive != 0;
      any_moves |= moves[i];
    }
    if (!any_moves) return false;
    const auto for_each_moving = [&](const auto& visit) {
      for (std::size_t i = 0; i < size_; ++i)
        if (moves[i]) visit(*trips_[i]);
    };
    for_each_moving([&](BlockTrip<A>& trip) { rays_.add_rays(trip); });
    rays_.end_rays();
    for_each_moving([](BlockTrip<A>& trip) { meet<F>(trip); });
    if constexpr (F.reuses_paths()) share_after_meeting();
    step();
    if constexpr (F.reuses_paths()) share_after_steps();
    for_each_moving([&](BlockTrip<A>& trip) { rays_.add_shadow_rays(trip); });
    rays_.end_shadow_rays();
    for_each_moving([&](BlockTrip<A>& trip) { go_on<F>(trip, lanes_); });
    if constexpr (F.reuses_paths()) share_after_leaving();
    return true;
  }

  [[nodiscard]] bool has_groups() const { return reuse_ && reuse_->has_groups(); }
  [[nodiscard]] bool shares_at(std::size_t bounces) const {
    return has_groups() && bounces_ == bounces;
  }
  // Calls visit(place, trip).
  template <class Visit>
  void for_each_place(const Visit& visit) {
    for (std::size_t i = 0; i < size_; ++i) visit(i, *trips_[i]);
  }
  void share_after_meeting() {
    if (shares_at(0))
      for_each_place(
          [&](std::size_t i, auto& trip) { reuse_->template meet_first_hits<F>(i, trip); });
    if (!shares_at(1)) return;
    for_each_place([&](std::size_t i, auto& trip) { reuse_->meet_points(i, trip); });
    reuse_->share(trips_);
  }
  void share_after_steps() {
    if (shares_at(1))
      for_each_place([&](std::size_t i, auto& trip) { reuse_->keep_always_light(i, trip); });
  }
  void share_after_leaving() {
    if (shares_at(0))
      for_each_place([&](std::size_t i, auto& trip) { reuse_->leave_first_hits(i, trip); });
    if (shares_at(1))
      for_each_place([&](std::size_t i, auto& trip) { reuse_->leave_points(i, trip); });
  }

  void step() {
    if constexpr (F.lanes) {
      step_together();
    } else {
      for_each_trip([](BlockTrip<A>& trip) { step_alone(trip, trip.alive); });
    }
  }

  static void step_alone(BlockTrip<A>& trip, LaneMask lanes) {
    for_each_lane(lanes, [&](std::uint32_t i) { step_lane<F>(trip, i); });
  }

  void step_together() {
    PlainModelSet met = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      BlockTrip<A>& trip = *trips_[i];
      find_plain_lanes(trip.context.scene, trip.block.hits,
                       lanes_without_medium<F>(trip.block, trip.alive), plain_[i]);
      step_alone(trip, trip.alive & ~plain_[i].all());
      met |= plain_[i].models();
    }
    PlainSteps<F, A> steps(lanes_);
    for (const PlainModel model : plain_models) {
      if ((met & bit_of(model)) == 0) continue;
      for (std::size_t i = 0; i < size_; ++i) steps.add(*trips_[i], plain_[i].of(model), model);
      steps.end(model);
    }
  }

  std::array<PathBlock, capacity> blocks_;
  std::array<std::optional<BlockTrip<A>>, capacity> trips_;
  std::size_t size_ = 0;
  std::size_t most_;
  std::size_t bounces_ = 0;  // on the way
  PlainLanes lanes_;
  std::array<PlainMasks, capacity> plain_;  // by trip
  TripRays<F, A> rays_;
  // Made with the first group: to set it up takes time that tiles without any need not spend.
  std::optional<PathReuse<A, F.reuses_paths() ? capacity : 1>> reuse_;
};

}  // namespace candela
