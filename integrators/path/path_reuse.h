// Pixels share what their paths find [Bekaert02]: a point y that a path met after its first hit x
// is met from the first hits of other pixels as well, if they see it, and what the path brings from
// y on then counts for all of them. For a segment more each path stands for a group of pixels.
//
// What comes to a first hit x from shared points is the sum over all paths of the group
//
//   throughput(x) * sum over y of w(x, y) L(y),    w(x, y) = p(x, y) / sum over x' of p(x', y),
//
// where p is the density with which x' finds y, per area: (cos at x') (cos at y) / (pi distance^2)
// if they see each other, else 0. It is the multi-sample estimator by the balance heuristic
// [Veach97, section 9.2], of which the throughput, cosine and distance at x cancel: no weight is
// above 1. Unbiased, since which points give and receive follows from where they lie alone: first
// hits on flat diffuse surfaces receive, points on such that do not shine give. Whatever else a
// path meets after its first hit is its own pixel's.
//
// Samples of the same index share, so that replicates stay independent of each other.
#pragma once

#include "integrators/path/block_trip.h"
#include "integrators/path/reuse_lanes.h"
#include "renderer/material/bump.h"

namespace candela {

// Diffuse, and the normal is the triangle's: what leaves it is the same in all directions, and
// depends on no direction from which it is seen.
[[nodiscard]] inline bool is_flat_diffuse(const Scene& scene, std::uint32_t geometry_index) {
  const Geometry& geometry = scene.geometries[geometry_index];
  return scene.plain_models[geometry_index] == PlainModel::Diffuse && geometry.normals.empty() &&
         !has_bump(scene.materials[geometry.material.index]);
}

// Of the trips of a convoy, which are given by their places. At most `capacity` of them.
template <class A, std::size_t capacity>
class PathReuse {
 public:
  // The trips from the last group's end to this one share.
  void end_group(std::size_t end) {
    if (end > group_begin(groups_)) group_ends_[groups_++] = end;
  }
  [[nodiscard]] bool has_groups() const { return groups_ > 0; }
  void clear() { groups_ = 0; }

  // The paths that are alive have left their first hits.
  void leave_first_hits(std::size_t place, const BlockTrip<A>& trip) {
    ReuseLanes& lanes = lanes_[place];
    lanes.receives = flat_diffuse_lanes(trip);
    lanes.gives = 0;
    lanes.x = trip.block.rays.origin;
    lanes.x_normal = trip.block.paths.receiving_normal;
    lanes.throughput = trip.block.paths.throughput;
  }

  // The rays from there have ended. What paths that give bring from now on is kept apart.
  void meet_next(std::size_t place, BlockTrip<A>& trip) {
    ReuseLanes& lanes = lanes_[place];
    PathBlock& block = trip.block;
    lanes.gives = lanes.receives & flat_diffuse_lanes(trip) & ~block.hits.instanced;
    for_each_lane(lanes.gives, [&](std::uint32_t i) {
      const Geometry& geometry = trip.context.scene.geometries[block.hits.geometry[i]];
      if (geometry.is_emissive())
        lanes.gives &= ~(1u << i);
      else
        begin_to_give(geometry, i, block, lanes);
    });
  }

  // Weights of the points that have been met, for each first hit of their group.
  template <class Trips>
  void share(Trips& trips) {
    for (std::size_t group = 0; group < groups_; ++group)
      for (std::size_t from = group_begin(group); from < group_ends_[group]; ++from)
        if (lanes_[from].gives != 0) share(from, group, trips);
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

  [[nodiscard]] static LaneMask flat_diffuse_lanes(const BlockTrip<A>& trip) {
    LaneMask lanes = 0;
    for_each_lane(trip.alive, [&](std::uint32_t i) {
      lanes |= flag(is_flat_diffuse(trip.context.scene, trip.block.hits.geometry[i])) << i;
    });
    return lanes;
  }

  static void begin_to_give(const Geometry& geometry, std::uint32_t i, PathBlock& block,
                            ReuseLanes& lanes) {
    const auto [p0, p1, p2] = surface_point_detail::corners_of(geometry, block.hits.triangle[i]);
    const auto met =
        surface_point_detail::plane_point(p0, p1, p2, block.hits.u[i], block.hits.v[i]);
    const bool is_front = dot(met.normal, block.rays.direction[i]) < 0;
    const Vec3f normal = is_front ? met.normal : -met.normal;
    lanes.y.set(i, met.position + normal * met.offset);
    lanes.y_normal.set(i, normal);
    lanes.radiance.set(i, block.paths.radiance[i]);
    block.paths.radiance.set(i, Rgb(0));
    block.paths.throughput.set(i, Rgb(1));
  }

  template <class Trips>
  void share(std::size_t from, std::size_t group, Trips& trips) {
    const std::size_t begin = group_begin(group);
    const std::size_t end = group_ends_[group];
    std::array<LaneMask, capacity> seen{};
    RayBlock segments;
    for (std::size_t at = begin; at < end; ++at) {
      const LaneMask lanes = lanes_[from].gives & lanes_[at].receives;
      const LaneMask found = connect(lanes_[at], lanes_[from], lanes, segments, weights_[from][at]);
      seen[at - begin] = found;
      if (at == from || found == 0) continue;  // a path sees what it met
      trips[at]->count_shadow_rays(found);
      seen[at - begin] = found & ~trips[at]->context.accelerator.occluded(segments, found);
    }
    weigh(std::span(weights_[from]).subspan(begin, end - begin),
          std::span(seen).first(end - begin));
  }

  template <class Trips>
  void gather(std::size_t group, Trips& trips) {
    const std::size_t begin = group_begin(group);
    const std::size_t end = group_ends_[group];
    std::array<Vec3Lanes, capacity> given{};
    for (std::size_t from = begin; from < end; ++from)
      for_each_lane(lanes_[from].gives, [&](std::uint32_t i) {
        PathLanes& paths = trips[from]->block.paths;
        given[from].set(i, paths.radiance[i]);
        paths.radiance.set(i, lanes_[from].radiance[i]);
      });
    for (std::size_t at = begin; at < end; ++at) {
      Vec3Lanes sum;
      for (std::size_t from = begin; from < end; ++from)
        if (lanes_[from].gives != 0) add_weighted(weights_[from][at], given[from], sum);
      for_each_lane(lanes_[at].receives, [&](std::uint32_t i) {
        trips[at]->block.paths.add_radiance(i, lanes_[at].throughput[i] * sum[i]);
      });
    }
  }

  std::array<ReuseLanes, capacity> lanes_;
  std::array<std::array<Lanes<float>, capacity>, capacity> weights_;  // of a point, at a first hit
  std::array<std::size_t, capacity> group_ends_{};
  std::size_t groups_ = 0;
};

}  // namespace candela
