// One camera sample as lab3's rasteriser shades it (docs/cli.md, "Whitted and raster"): whitted's
// direct lighting without shadows or bounces, holes seen through (`if (alpha < .2) discard`), the
// rest opaque.
#pragma once

#include "integrators/whitted/lab_shading.h"

namespace candela {

template <class A>
[[nodiscard]] inline FilmSample trace_raster(const LabContext<A>& context, const Ray& camera_ray,
                                             TileCounts& counts) {
  FilmSample sample;
  Ray ray = camera_ray;
  ++counts.rays.camera;
  for (int layer = 0; layer < most_lab_layers; ++layer) {
    if (!is_traceable(ray)) {
      sample.radiance = invalid_radiance;
      return sample;
    }
    const Hit hit = context.accelerator.intersect(ray);
    if (!hit.is_hit()) break;
    const Vec3f wo = -ray.direction;
    const LabPoint point = lab_point_at(context.scene, context.rules, hit, wo);
    if (point.surface.alpha >= lab_hole_below) {
      lab_record_first(context, point, wo, sample);
      sample.radiance = lab_light_at(context, point, hit, wo, counts);
      return sample;
    }
    ray = spawn_ray(point.place, ray.direction);
  }
  sample.alpha = 0;
  return sample;
}

}  // namespace candela
