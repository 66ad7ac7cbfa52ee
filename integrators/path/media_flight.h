// A path's ray from where it was sampled to what happens next: a collision with a medium, a
// surface, or nothing any more. Boundaries of media without a surface are no event.
#pragma once

#include <optional>

#include "integrators/path/path_step.h"
#include "integrators/path/shadow_walk.h"
#include "renderer/medium/free_flight.h"

namespace candela {

// In the scene's unit, far more than rays keep off surfaces: a flight that ends within the first
// half of a longer way has no need to know where exactly its medium ends.
inline constexpr float near_surface = 1e-3f;

struct MediaFlight {
  Hit hit;             // of the surface, where there is no collision
  float distance = 0;  // to it, from where the ray was sampled
  bool collides = false;
  Vec3f place{0};  // of the collision
};

// Follows the ray, which met `hit`, and turns it into its last part; `medium`: around the path,
// then at the flight's end. What the flight leaves of the light goes into the path's throughput.
template <class A>
[[nodiscard]] inline MediaFlight fly(const PathContext<A>& context, std::uint32_t bits,
                                     const Hit& hit, Ray& ray, MediumHandle& medium,
                                     PathState& path, TileCounts& counts) {
  const Scene& scene = context.scene;
  FreeFlight free;
  if (scene.features.scattering_media) free = start_flight(path.throughput, bits);
  MediaFlight flight;
  flight.hit = hit;
  for (int crossed = 0; crossed <= most_boundaries; ++crossed) {
    const float t = flight.hit.is_hit() ? flight.hit.t : infinity;
    std::optional<SurfacePoint> met;
    if (medium) {
      const Medium& around = scene.media[medium.index];
      float end = t;
      const bool ends_at_surface = around.scatters() && flight.hit.is_hit();
      if (ends_at_surface && (t < near_surface || may_pass(around, t / 2, free))) {
        met = met_point(scene, flight.hit, -ray.direction);
        end = end_in_medium(t, *met, ray.direction);
      }
      const float way = fly_through(around, end, free);
      if (way < infinity) {
        flight.collides = true;
        flight.place = ray.origin + ray.direction * way;
        path.throughput *= collision_weight(free, around);
        return flight;
      }
    }
    flight.distance += t;
    if (!flight.hit.is_hit() || !is_clear_boundary(scene, flight.hit)) {
      path.throughput *= passing_weight(free);
      return flight;
    }
    if (!met) met = met_point(scene, flight.hit, -ray.direction);
    medium = medium_beyond(scene, flight.hit, *met, medium);
    ray = spawn_ray(*met, ray.direction);
    flight.hit = Hit{};
    if (!is_traceable(ray)) {
      path.radiance = invalid_radiance;
      break;
    }
    ++counts.rays.indirect;
    flight.hit = context.accelerator.intersect(ray);
  }
  path.throughput = Rgb(0);
  return flight;
}

}  // namespace candela
