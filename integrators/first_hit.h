// What the film's layers (AOVs) keep of the first hit. For all integrators.
#pragma once

#include "renderer/bsdf/albedo.h"
#include "renderer/camera/camera.h"
#include "renderer/film/film.h"
#include "renderer/geometry/surface_point.h"
#include "renderer/scene/scene.h"

namespace candela {

inline void record_first_hit(const Scene& scene, const Camera& camera, const Geometry& geometry,
                             const SurfacePoint& point, const Bsdf& bsdf, const Vec3f& wo_local,
                             FilmSample& sample) {
  sample.has_hit = true;
  sample.albedo = albedo_estimate(bsdf, wo_local);
  sample.normal = point.shading.z;
  sample.position = scene.normalisation.to_file(point.position);
  sample.depth =
      static_cast<double>(camera.distance_to(point.position)) / scene.normalisation.scale;
  sample.material = geometry.material.index;
}

}  // namespace candela
