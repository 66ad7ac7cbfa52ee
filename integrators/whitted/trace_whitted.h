// One camera sample of lab3's ray tracer (docs/cli.md, "Whitted and raster"): a single ray that at
// each surface either goes on straight behind it (alpha < 0.9) or in the mirror direction;
// background black.
#pragma once

#include "integrators/whitted/lab_shading.h"

namespace candela {

// The ray behind a surface, or from it; weight is that of what the ray will find.
struct LabWalk {
  Ray ray;
  Rgb weight{1};
  float clear = 1;  // the share of the camera ray that nothing has covered yet
};

// Adds what the point shows and sets out for the next one.
template <class A>
inline void step_whitted(const LabContext<A>& context, const LabPoint& point, const Hit& hit,
                         LabWalk& walk, Rgb& colour, TileCounts& counts) {
  const Vec3f wo = -walk.ray.direction;
  const LabSurface& surface = point.surface;
  const bool is_solid = surface.alpha >= lab_solid_from;
  const Rgb shown = is_solid ? Rgb{1} - surface.mirror : Rgb{surface.alpha};
  const Rgb share = walk.weight * shown;
  if (!is_black(share)) colour += share * lab_light_at(context, point, hit, wo, counts);
  if (is_solid) {
    const Vec3f& n = point.normal;
    walk.weight *= surface.mirror;
    walk.clear = 0;
    walk.ray = spawn_ray(point.place, normalize(n * (2 * dot(n, wo)) - wo));
  } else {
    walk.weight *= surface.behind;
    walk.clear *= 1 - surface.alpha;
    walk.ray = spawn_ray(point.place, walk.ray.direction);
  }
}

template <class A>
[[nodiscard]] inline FilmSample trace_whitted(const LabContext<A>& context, const Ray& camera_ray,
                                              TileCounts& counts) {
  FilmSample sample;
  Rgb colour(0);
  LabWalk walk{.ray = camera_ray};
  for (int depth = 0; depth < context.rules.max_depth; ++depth) {
    ++(depth == 0 ? counts.rays.camera : counts.rays.indirect);
    if (!is_traceable(walk.ray)) {
      sample.radiance = invalid_radiance;
      return sample;
    }
    const Hit hit = context.accelerator.intersect(walk.ray);
    if (!hit.is_hit()) {
      sample.alpha = 1 - walk.clear;
      break;
    }
    const Vec3f wo = -walk.ray.direction;
    const LabPoint point = lab_point_at(context.scene, context.rules, hit, wo);
    lab_record_first(context, point, wo, sample);
    step_whitted(context, point, hit, walk, colour, counts);
    if (is_black(walk.weight)) break;
  }
  sample.radiance = colour;
  return sample;
}

}  // namespace candela
