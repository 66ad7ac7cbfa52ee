// First hits, as the points that others' paths met light them (path_reuse.h).
#pragma once

#include "integrators/path/path_block.h"
#include "integrators/path/reuse_lanes.h"
#include "integrators/path/shared_surfaces.h"

namespace candela {

// Where the surface is Lambert's and the path goes on, all but the geometric normal follows from
// the path.
inline void receive_by_path(const Scene& scene, std::uint32_t i, const PathBlock& block,
                            FirstHitLanes& x) {
  if (has_flat_shading(scene, block.hits.geometry[i])) return;
  x.are_flat = false;
  const Vec3f wi = block.rays.direction[i];
  x.geometric_normal.set(i, bare_point_at(scene, block.hits[i], wi).geometric_normal);
}

// From what the camera ray met; false where nothing is received. A path may have ended since its
// direction was above the shading normal's horizon alone, or beneath the surface: what others found
// is met from there as from any.
[[nodiscard]] inline bool receive_by_surface(const Scene& scene, std::uint32_t i,
                                             const PathBlock& block, bool is_alive,
                                             FirstHitLanes& x) {
  const SurfaceMet met = surface_met(scene, block.hits[i], -x.camera[i]);
  const SharedLobe& lobe = met.lobe;
  if (lobe.is_never_drawn()) return false;
  const SurfacePoint& point = met.point;
  const Rgb albedo = x.throughput[i] * lobe.albedo * lobe.crossing_o;
  x.are_flat &= point.is_flat;
  x.position.set(i, point.position + point.geometric_normal * point.offset);
  x.shading_normal.set(i, point.shading.z);
  x.geometric_normal.set(i, point.geometric_normal);
  x.even.set(i, albedo * lobe.crossing.even);
  x.shaped.set(i, albedo * lobe.crossing.shaped);
  x.probability[i] = lobe.probability();
  x.shapes.set(i, lobe.crossing);
  x.largest[i] = max_component(albedo * lobe.crossing.at(1));
  if (!is_alive) return true;
  if (x.lobe[i] < lobe.others) x.drawn &= ~(1u << i);
  Rgb diffuse(0);
  if (block.paths.is_delta[i] == 0) {
    const float cos_i = dot(point.shading.z, block.rays.direction[i]);
    diffuse = x.throughput[i] * lobe.crossing_o * lobe.value_below(cos_i) / block.paths.bsdf_pdf[i];
  }
  x.diffuse.set(i, diffuse);
  x.glossy.set(i, glm::max(block.paths.throughput[i] - diffuse, Rgb(0)));
  return true;
}

// The paths that are alive have left their first hits. Returns the lanes that receive, of those
// that met a surface.
[[nodiscard]] inline LaneMask find_receivers(const Scene& scene, const PathBlock& block,
                                             LaneMask met, LaneMask alive, FirstHitLanes& x) {
  x.position = block.rays.origin;
  x.shading_normal = x.geometric_normal = block.paths.receiving_normal;
  x.are_flat = true;
  x.even = x.diffuse = block.paths.throughput;
  x.shaped = x.glossy = {};
  x.shapes = {};
  x.probability.fill(1);
  for (std::uint32_t i = 0; i < block_size; ++i) x.largest[i] = max_component(x.even[i]);
  x.drawn = alive;
  LaneMask receives = 0;
  for_each_lane(met, [&](std::uint32_t i) {
    const std::uint32_t geometry = block.hits.geometry[i];
    if (!receives_shared(scene, geometry)) return;
    const bool is_alive = (alive >> i & 1) != 0;
    if (is_alive && is_lambertian(scene, geometry))
      receive_by_path(scene, i, block, x);
    else if (!receive_by_surface(scene, i, block, is_alive, x))
      return;
    receives |= 1u << i;
  });
  return receives;
}

}  // namespace candela
