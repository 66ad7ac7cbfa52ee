// Skies in lanes: what environment.h says of one direction, bit by bit, of the directions of many
// paths (plain_lanes.h).
#pragma once

#include "integrators/path/path_block.h"
#include "integrators/path/plain_lanes.h"
#include "renderer/light/environment.h"

namespace candela {

// Lanes that are worth it.
inline constexpr std::uint32_t fewest_in_sky = 4;

// Whether light samples may be of a map.
[[nodiscard]] inline bool has_sky_map(const Scene& scene) {
  return scene.environment && !scene.environment->is_constant() && !scene.environment->is_black();
}

// EnvironmentPoint, by lane.
struct SkyPointLanes {
  [[nodiscard]] EnvironmentPoint operator[](std::size_t i) const { return {face[i], {u[i], v[i]}}; }
  void set(std::size_t i, const EnvironmentPoint& point) {
    face[i] = point.face;
    u[i] = point.uv.x;
    v[i] = point.uv.y;
  }

  Lanes<std::uint32_t> face;
  Lanes<float> u, v;
};
// Of a map's directions.
void find_sky_points(const Environment& sky, const Vec3Lanes& directions, SkyPointLanes& points);

// What a map sends from the directions in the given lanes. Where those are not side by side, all
// texels are asked for before the first is looked at, so that their waits overlap.
void find_sky_radiance(const Environment& sky, const TextureStore& textures, LaneMask lanes,
                       const Vec3Lanes& directions, Coherence coherence, Vec3Lanes& radiance);

// Light samples of the given lanes, whose lamp is the sky, a map, as if its radiance were 1.
void sample_sky_in_lanes(const Environment& sky, LaneMask lanes, PlainLanes& plain);

// Light from the sky that the paths in the given lanes met (add_environment()).
void add_met_sky(const Scene& scene, LaneMask lanes, const Vec3Lanes& directions,
                 const Vec3Lanes& radiance, PathLanes& paths);

}  // namespace candela
