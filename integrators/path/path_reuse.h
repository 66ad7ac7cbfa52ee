// Pixels share what their paths find [Bekaert02]: a point y that a path met after its first hit x
// is met from the first hits of other samples as well, if they see it, and what the path brings
// from y on then counts for all of them. For a segment more each path stands for a group.
//
// What comes to a first hit x from shared points is the sum over all paths of the group
//
//   throughput(x) * sum over y of w(x, y) L(y),    w(x, y) = p(x, y) / sum over x' of p(x', y),
//
// where p is the density with which x' finds y, per area: (cos at x') (cos at y) / (pi distance^2)
// if they see each other, else 0. It is the multi-sample estimator by the balance heuristic
// [Veach97, section 9.2], of which the throughput, cosine and distance at x cancel: no weight is
// above 1. Unbiased, since which points give to which first hits follows from where both lie alone:
// first hits on diffuse surfaces receive, points on such that do not shine give to those from which
// they are seen with a shading normal that is not bent. Whatever else a path meets after its first
// hit is its own pixel's.
//
// Which samples share: reuse_groups.h.
#pragma once

#include "integrators/path/block_trip.h"
#include "integrators/path/gathered_rays.h"
#include "integrators/path/reuse_lanes.h"
#include "integrators/path/shared_surfaces.h"
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

  // The paths that are alive have left their first hits; others that met a surface have ended
  // there.
  void leave_first_hits(std::size_t place, const BlockTrip<A>& trip) {
    ReuseLanes& lanes = lanes_[place];
    const Scene& scene = trip.context.scene;
    const PathBlock& block = trip.block;
    lanes.receives = 0;
    lanes.gives = 0;
    lanes.is_x_flat = true;
    lanes.x = block.rays.origin;
    lanes.x_shading = block.paths.receiving_normal;
    lanes.x_geometric = lanes.x_shading;
    lanes.throughput = block.paths.throughput;
    if (trip.bounce == 0) return;  // no camera ray was traced
    for_each_lane(trip.place.lanes & block.hits.met, [&](std::uint32_t i) {
      const std::uint32_t geometry = block.hits.geometry[i];
      if (!receives_shared(scene, geometry)) return;
      const bool is_alive = (trip.alive >> i & 1) != 0;
      const bool is_flat = has_flat_shading(scene, geometry);
      if (is_flat && !is_alive) return;  // black
      lanes.receives |= 1u << i;
      if (is_flat) return;
      lanes.is_x_flat = false;
      is_alive ? receive_alive(scene, i, block, lanes) : receive_ended(scene, i, block, lanes);
    });
  }

  // The rays from there have ended. What paths that give bring from now on is kept apart.
  void meet_next(std::size_t place, BlockTrip<A>& trip) {
    ReuseLanes& lanes = lanes_[place];
    lanes.is_y_flat = true;
    for_each_lane(lanes.receives & trip.alive, [&](std::uint32_t i) {
      if (!gives_shared(trip.context.scene, trip.block.hits.geometry[i])) return;
      if (meet_point(trip.context.scene, i, trip.block, lanes)) begin_to_give(i, trip.block, lanes);
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
        weigh(std::span(weights_[from]).subspan(begin, size),
              std::span(seen_[from]).subspan(begin, size));
      });
  }

  // The paths have ended.
  template <class Trips>
  void gather(Trips& trips) {
    for (std::size_t group = 0; group < groups_; ++group) gather(group, trips);
  }

 private:
  [[nodiscard]] std::size_t group_begin(std::size_t group) const {
    return group == 0 ? 0 : group_ends_[group - 1];
  }

  // A first hit whose shading normal is its own.
  static void receive_alive(const Scene& scene, std::uint32_t i, const PathBlock& block,
                            ReuseLanes& lanes) {
    const Vec3f wi = block.rays.direction[i];
    lanes.x_geometric.set(i, point_met(scene, block.hits[i], wi).geometric_normal);
  }
  // And whose path ended, since its direction was above the shading normal's horizon alone: what
  // others found is met from there as from any.
  static void receive_ended(const Scene& scene, std::uint32_t i, const PathBlock& block,
                            ReuseLanes& lanes) {
    const Vec3f wo = -block.rays.direction[i];
    const Hit hit = block.hits[i];
    const Geometry& geometry = scene.geometries[hit.geometry];
    const Material& material = scene.materials[geometry.material.index];
    const SurfacePoint point = surface_point_at<general_features>(scene, hit, material, wo);
    lanes.x.set(i, point.position + point.geometric_normal * point.offset);
    lanes.x_shading.set(i, point.shading.z);
    lanes.x_geometric.set(i, point.geometric_normal);
    const Bsdf bsdf = bsdf_at(material, scene.textures, texture_point_of(point), point.is_front);
    lanes.throughput.set(i, block.paths.throughput[i] * bsdf.diffuse);
  }

  // On the side that `wo` is on.
  [[nodiscard]] static SurfacePoint point_met(const Scene& scene, const Hit& hit, const Vec3f& wo) {
    const Instance* instance = hit.is_instanced() ? &scene.instances[hit.instance] : nullptr;
    return make_triangle_point(scene.geometries[hit.geometry], instance, hit, wo, false);
  }

  // The point that a path met; false where it is seen with a normal that is bent.
  [[nodiscard]] static bool meet_point(const Scene& scene, std::uint32_t i, const PathBlock& block,
                                       ReuseLanes& lanes) {
    const Vec3f wo = -block.rays.direction[i];
    const SurfacePoint point = point_met(scene, block.hits[i], wo);
    const Vec3f& geometric = point.geometric_normal;
    Vec3f shading = geometric;
    if (!point.is_flat) {
      const float side = dot(point.front_normal, geometric);
      shading = side < 0 ? -point.front_normal : point.front_normal;
      const float between = std::abs(side);
      if (!is_unbent(dot(shading, wo), between, dot(geometric, wo))) return false;
      lanes.is_y_flat = false;
    }
    lanes.y.set(i, point.position + geometric * point.offset);
    lanes.y_shading.set(i, shading);
    lanes.y_geometric.set(i, geometric);
    lanes.y_between[i] = dot(shading, geometric);
    return true;
  }
  static void begin_to_give(std::uint32_t i, PathBlock& block, ReuseLanes& lanes) {
    lanes.gives |= 1u << i;
    lanes.radiance.set(i, block.paths.radiance[i]);
    block.paths.radiance.set(i, Rgb(0));
    block.paths.throughput.set(i, Rgb(1));
  }

  template <class Visit>
  void for_each_giver(std::size_t group, const Visit& visit) const {
    for (std::size_t from = group_begin(group); from < group_ends_[group]; ++from)
      if (lanes_[from].gives != 0) visit(from);
  }

  // Which first hits of a group see the points that paths of a block of it met.
  template <class Trips>
  void connect_group(std::size_t from, std::size_t group, Trips& trips) {
    RayBlock segments;
    for (std::size_t at = group_begin(group); at < group_ends_[group]; ++at) {
      const LaneMask lanes = lanes_[from].gives & lanes_[at].receives;
      LaneMask& seen = seen_[from][at];
      seen = 0;
      if (lanes == 0) continue;
      seen = connect(lanes_[at], lanes_[from], lanes, segments, weights_[from][at]);
      if (at == from || seen == 0) continue;  // a path sees what it met
      trips[at]->count_segments(seen);
      const A& accelerator = trips[at]->context.accelerator;
      if (!is_gathered(accelerator, seen)) {
        seen &= ~accelerator.occluded(segments, seen);
        continue;
      }
      for_each_lane(seen, [&](std::uint32_t lane) {
        segments_.add(segments[lane], {from, at, lane});
        if (segments_.is_full()) end_segments(trips);
      });
    }
  }

  // Tells which of the segments that were gathered are clear.
  template <class Trips>
  void end_segments(const Trips& trips) {
    if (segments_.is_empty()) return;
    const A& accelerator = trips[0]->context.accelerator;
    for_each_lane(accelerator.occluded(segments_.rays(), segments_.lanes()), [&](std::uint32_t k) {
      const auto& [from, at, lane] = segments_.place(k);
      seen_[from][at] &= ~(1u << lane);
    });
    segments_.clear();
  }

  template <class Trips>
  void gather(std::size_t group, Trips& trips) {
    const std::size_t begin = group_begin(group);
    const std::size_t end = group_ends_[group];
    std::array<Vec3Lanes, capacity> given{};
    for_each_giver(group, [&](std::size_t from) {
      for_each_lane(lanes_[from].gives, [&](std::uint32_t i) {
        PathLanes& paths = trips[from]->block.paths;
        given[from - begin].set(i, paths.radiance[i]);
        paths.radiance.set(i, lanes_[from].radiance[i]);
      });
    });
    for (std::size_t at = begin; at < end; ++at) {
      Vec3Lanes sum;
      for_each_giver(group, [&](std::size_t from) {
        add_weighted(weights_[from][at], given[from - begin], sum);
      });
      for_each_lane(lanes_[at].receives, [&](std::uint32_t i) {
        const Rgb shared = lanes_[at].throughput[i] * sum[i];
        trips[at]->block.paths.add_radiance(i, shared);
        lanes_[at].gain.set(i, shared - lanes_[at].throughput[i] * given[at - begin][i]);
      });
    }
  }

  struct Segment {
    std::size_t from = 0;    // whose paths' points
    std::size_t at = 0;      // are met from this block's first hits
    std::uint32_t lane = 0;  // in this lane of both
  };

  std::array<ReuseLanes, capacity> lanes_;
  std::array<std::array<Lanes<float>, capacity>, capacity> weights_;  // of a point, at a first hit
  std::array<std::array<LaneMask, capacity>, capacity> seen_;  // whether it is met from there
  GatheredRays<Segment> segments_;
  std::array<std::size_t, capacity> group_ends_{};
  std::size_t groups_ = 0;
};

}  // namespace candela
