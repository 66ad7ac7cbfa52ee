// What the paths of a block have to share (path_reuse.h), by lane, and the loops over lanes of it.
#pragma once

#include <array>
#include <span>

#include "renderer/accel/ray_block.h"
#include "renderer/math/lanes.h"

namespace candela {

struct ReuseLanes {
  LaneMask receives = 0;  // whose first hit x can be reached by others' light
  LaneMask gives = 0;     // whose path met a point y, from which on it serves others
  // Places, off their surfaces by their errors; shading and geometric normals on the side that is
  // seen. Where all are flat the shading normals are the geometric ones.
  Vec3Lanes x, x_shading, x_geometric;
  Vec3Lanes y, y_shading, y_geometric;
  Lanes<float> y_between{};  // the cosine between both
  bool is_x_flat = true, is_y_flat = true;
  Vec3Lanes throughput;  // from the camera to x, with the surface's albedo
  Vec3Lanes radiance;    // of the path up to y
  Vec3Lanes gain;        // what comes to x from all points, less what comes from the path's own
};

// Segments from the first hits of `at` to the points of `from`, and the densities with which the
// cosine lobes at x find y if nothing is between them, per area and times pi. Returns the lanes in
// which they may, of those asked for; in others the density is 0.
[[nodiscard]] LaneMask connect(const ReuseLanes& at, const ReuseLanes& from, LaneMask lanes,
                               RayBlock& segments, Lanes<float>& density);

// Densities become the weights of the balance heuristic [Veach97, section 9.2]: `seen` says of each
// in which lanes the segment is clear.
void weigh(std::span<Lanes<float>> densities, std::span<const LaneMask> seen);

// sum += weight * radiance.
void add_weighted(const Lanes<float>& weight, const Vec3Lanes& radiance, Vec3Lanes& sum);

}  // namespace candela
