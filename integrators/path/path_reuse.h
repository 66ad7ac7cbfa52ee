// Pixels share what their paths find [Bekaert02]: a point y that a path met after its first hit x
// is met from the first hits of other samples as well, if they see it, and what the path brings
// from y on then counts for all of them. For a segment more each path stands for a group.
//
// Shared is between the diffuse lobes of surfaces (shared_lobe.h): all of Lambert's, and of glossy
// ones what is below their highlights. What highlights send, at x or at y, is their own path's.
// What comes to a first hit x from shared points is the sum over all paths of the group that drew
// their directions from the diffuse lobe
//
//   albedo(x) * sum over y of w(x, y) L(y),    w(x, y) = g(x, y) / sum over x' of q(x') g(x', y),
//
// where g = (cos at x) (cos at y) / (pi distance^2) if x and y see each other, else 0, and q(x') is
// the probability of the diffuse lobe at x': q g is the density with which x' finds y, per area. It
// is the multi-sample estimator by the balance heuristic [Veach97, section 9.2], of which the
// throughput, cosine and distance at x cancel: no weight is above 1 / q. Unbiased, since which
// points give to which first hits follows from where both lie alone: points that do not shine give
// to those from which they are seen with a shading normal that is not bent. Where cut-outs let some
// of the light through, whether two points see each other is drawn at random for each two of them,
// whoever found the point: the balance heuristic over points and draws together.
// Whatever else a path meets after its first hit is its own pixel's.
//
// Which samples share: reuse_groups.h.
#pragma once

#include "integrators/path/block_trip.h"
#include "integrators/path/gathered_rays.h"
#include "integrators/path/reuse_first_hits.h"
#include "integrators/path/reuse_points.h"
#include "integrators/path/trace_block.h"

namespace candela {

// Of the trips of a convoy, which are given by their places. At most `capacity` of them.
template <class A, std::size_t capacity>
class PathReuse {
 public:
  // The trips from the last group's end to this one share.
  void end_group(std::size_t end) {
    for (std::size_t i = group_begin(groups_); i < end; ++i) lanes_[i].gain = {};
    if (end > group_begin(groups_)) group_ends_[groups_++] = end;
  }
  [[nodiscard]] bool has_groups() const { return groups_ > 0; }
  void clear() { groups_ = 0; }

  // By how much what is shared makes a block's samples larger than what their own paths found.
  [[nodiscard]] const Vec3Lanes& gain(std::size_t place) const { return lanes_[place].gain; }

  // The camera rays have met the first hits.
  template <FeatureSet F>
  void meet_first_hits(std::size_t place, const BlockTrip<A>& trip) {
    FirstHitLanes& x = lanes_[place].x;
    const Scene& scene = trip.context.scene;
    x.camera = trip.block.rays.direction;
    x.throughput = trip.block.paths.throughput;
    if (!needs_lobes(scene)) return;
    for_each_lane(trip.alive, [&](std::uint32_t i) {
      const std::uint32_t geometry = trip.block.hits.geometry[i];
      if (receives_shared(scene, geometry) && !is_lambertian(scene, geometry))
        x.lobe[i] = numbers_of<F>(trip, i).lobe;
    });
  }

  // The paths that are alive have left their first hits; others that met a surface have ended
  // there.
  void leave_first_hits(std::size_t place, const BlockTrip<A>& trip) {
    ReuseLanes& lanes = lanes_[place];
    lanes.receives = lanes.apart = lanes.gives = 0;
    if (trip.bounce == 0) return;  // no camera ray was traced
    lanes.receives = find_receivers(trip.context.scene, trip.block,
                                    trip.place.lanes & trip.block.hits.met, trip.alive, lanes.x);
  }

  // The rays from there have ended. What paths bring from now on is kept apart where it may serve
  // others: not where a path's direction is drawn from a highlight, of which others know nothing.
  void meet_points(std::size_t place, BlockTrip<A>& trip) {
    ReuseLanes& lanes = lanes_[place];
    const Scene& scene = trip.context.scene;
    reset_points(lanes.y);
    for_each_lane(lanes.receives & trip.alive, [&](std::uint32_t i) {
      const Hit hit = trip.block.hits[i];
      if (!gives_shared(scene, hit.geometry)) return;
      if (!place_point(scene, hit, -trip.block.rays.direction[i], i, lanes.y)) return;
      lanes.apart |= 1u << i;
      set_apart(scene, i, trip.block, lanes.y);
    });
    lanes.gives = lanes.apart & lanes.x.drawn;
  }

  // The lights that are sampled at every hit have been.
  void keep_always_light(std::size_t place, const BlockTrip<A>& trip) {
    lanes_[place].y.always = trip.block.paths.radiance;
  }

  // The paths have left the points, which no shadow ray is on its way to any more.
  void leave_points(std::size_t place, BlockTrip<A>& trip) {
    SharedPointLanes& y = lanes_[place].y;
    for_each_lane(y.glossy, [&](std::uint32_t i) {
      leave_point(trip.context.scene, i, trip.after, trip.block, y);
    });
  }

  // Weights of the points that have been met, for each first hit of their group.
  template <class Trips>
  void share(Trips& trips) {
    for (std::size_t group = 0; group < groups_; ++group)
      for_each_giver(group, [&](std::size_t from) { connect_group(from, group, trips); });
    end_segments(trips);
    for (std::size_t group = 0; group < groups_; ++group)
      for_each_giver(group, [&](std::size_t from) {
        const std::size_t begin = group_begin(group);
        const std::size_t size = group_ends_[group] - begin;
        const auto segments = std::span(segments_[from]).subspan(begin, size);
        const auto at = std::span(lanes_).subspan(begin, size);
        weigh(segments, std::span(seen_[from]).subspan(begin, size), at);
        find_importance(importance_of(segments, at), lanes_[from].gives, lanes_[from].y);
      });
    for (std::size_t i = 0; i < group_begin(groups_); ++i)
      scale_roulette(lanes_[i].y, lanes_[i].apart, trips[i]->block.paths);
  }

  // The paths have ended.
  template <class Trips>
  void gather(Trips& trips) {
    for (std::size_t group = 0; group < groups_; ++group) {
      collect(group, trips);
      for (std::size_t at = group_begin(group); at < group_ends_[group]; ++at)
        distribute(group, at, trips[at]->block.paths);
    }
  }

 private:
  [[nodiscard]] std::size_t group_begin(std::size_t group) const {
    return group == 0 ? 0 : group_ends_[group - 1];
  }

  template <class Visit>
  void for_each_giver(std::size_t group, const Visit& visit) const {
    for (std::size_t from = group_begin(group); from < group_ends_[group]; ++from)
      if (lanes_[from].gives != 0) visit(from);
  }

  // Which first hits of a group see the points that paths of a block of it met.
  template <class Trips>
  void connect_group(std::size_t from, std::size_t group, Trips& trips) {
    RayBlock rays;
    for (std::size_t at = group_begin(group); at < group_ends_[group]; ++at) {
      const LaneMask lanes = lanes_[from].gives & lanes_[at].receives;
      LaneMask& seen = seen_[from][at];
      seen = 0;
      if (lanes == 0) continue;
      seen = connect(lanes_[at], lanes_[from], lanes, rays, segments_[from][at]);
      if (at == from || seen == 0) continue;  // a path sees what it met
      trips[at]->count_segments(seen);
      const A& accelerator = trips[at]->context.accelerator;
      if (!is_gathered(accelerator, seen)) {
        seen &= ~accelerator.occluded(rays, seen);
        continue;
      }
      for_each_lane(seen, [&](std::uint32_t lane) {
        rays_.add(rays[lane], {from, at, lane});
        if (rays_.is_full()) end_segments(trips);
      });
    }
  }

  // Tells which of the segments that were gathered are clear.
  template <class Trips>
  void end_segments(const Trips& trips) {
    if (rays_.is_empty()) return;
    const A& accelerator = trips[0]->context.accelerator;
    for_each_lane(accelerator.occluded(rays_.rays(), rays_.lanes()), [&](std::uint32_t k) {
      const auto& [from, at, lane] = rays_.place(k);
      seen_[from][at] &= ~(1u << lane);
    });
    rays_.clear();
  }

  // What points send out, and what of it reaches their own first hits alone.
  template <class Trips>
  void collect(std::size_t group, Trips& trips) {
    for (std::size_t at = group_begin(group); at < group_ends_[group]; ++at) {
      ReuseLanes& lanes = lanes_[at];
      PathLanes& paths = trips[at]->block.paths;
      sent_even_[at] = sent_shaped_[at] = {};
      for_each_lane(lanes.apart, [&](std::uint32_t i) {
        const Rgb radiance = paths.radiance[i];
        const Rgb shared = shared_light(lanes.y, i, radiance);
        const Rgb to_x = lanes.y.towards_x[i] * shared;
        if ((lanes.gives >> i & 1) != 0 && is_finite(shared)) {  // else it would spoil them all
          sent_even_[at].set(i, shared * lanes.y.even[i]);
          sent_shaped_[at].set(i, shared * lanes.y.shaped[i]);
        }
        paths.radiance.set(
            i, lanes.y.before[i] + lanes.x.glossy[i] * to_x +
                   (lanes.x.diffuse[i] + lanes.x.glossy[i]) * glossy_light(lanes.y, i, radiance));
        lanes.gain.set(i, -lanes.x.diffuse[i] * to_x);
      });
    }
  }

  // What reaches the first hits of a block from all points of the group.
  void distribute(std::size_t group, std::size_t at, PathLanes& paths) {
    ReuseLanes& lanes = lanes_[at];
    Vec3Lanes even, shaped;
    for_each_giver(group, [&](std::size_t from) { add_light(from, at, even, shaped); });
    for_each_lane(lanes.receives, [&](std::uint32_t i) {
      const Rgb shared = lanes.x.even[i] * even[i] + lanes.x.shaped[i] * shaped[i];
      paths.add_radiance(i, shared);
      lanes.gain.set(i, lanes.gain[i] + shared);
    });
  }
  void add_light(std::size_t from, std::size_t at, Vec3Lanes& even, Vec3Lanes& shaped) {
    const LaneMask seen = seen_[from][at];
    if (seen == 0) return;
    const SegmentLanes& segments = segments_[from][at];
    const LobeShapeLanes& at_x = lanes_[at].x.shapes;
    const LobeShapeLanes& at_y = lanes_[from].y.shapes;
    Vec3Lanes light = sent_even_[from];
    if (!at_y.are_even())
      add_weighted(shapes_at(at_y, seen, segments.cos_y), sent_shaped_[from], light);
    add_weighted(segments.density, light, even);
    if (!at_x.are_even())
      add_shaped(segments.density, shapes_at(at_x, seen, segments.cos_x), light, shaped);
  }

  struct Segment {
    std::size_t from = 0;    // whose paths' points
    std::size_t at = 0;      // are met from this block's first hits
    std::uint32_t lane = 0;  // in this lane of both
  };

  std::array<ReuseLanes, capacity> lanes_;
  // Of a block's points and another block's first hits: densities, at last the weights, and in
  // which lanes the ones are seen from the others.
  std::array<std::array<SegmentLanes, capacity>, capacity> segments_;
  std::array<std::array<LaneMask, capacity>, capacity> seen_;
  GatheredRays<Segment> rays_;
  std::array<Vec3Lanes, capacity> sent_even_, sent_shaped_;  // what a block's points send out
  std::array<std::size_t, capacity> group_ends_{};
  std::size_t groups_ = 0;
};

}  // namespace candela
