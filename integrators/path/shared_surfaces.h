// The surfaces between which pixels share what paths find (path_reuse.h): diffuse ones.
#pragma once

#include "renderer/material/bump.h"
#include "renderer/scene/scene.h"

namespace candela {

// Whether what others' paths met can be met from there as well.
[[nodiscard]] inline bool receives_shared(const Scene& scene, std::uint32_t geometry) {
  return scene.plain_models[geometry] == PlainModel::Diffuse;
}

// Whether what a path meets there can serve others: what leaves it is alike in all directions but
// those from which its shading normal is bent (surface_point.h), which its geometry tells.
[[nodiscard]] inline bool gives_shared(const Scene& scene, std::uint32_t geometry) {
  const Geometry& of = scene.geometries[geometry];
  return receives_shared(scene, geometry) && !has_bump(scene.materials[of.material.index]) &&
         !of.is_emissive();
}

// The shading normal is the triangle's.
[[nodiscard]] inline bool has_flat_shading(const Scene& scene, std::uint32_t geometry) {
  const Geometry& of = scene.geometries[geometry];
  return of.normals.empty() && !has_bump(scene.materials[of.material.index]);
}

}  // namespace candela
