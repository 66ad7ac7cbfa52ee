// The surfaces between which pixels share what paths find (path_reuse.h): those with a diffuse lobe
// (shared_lobe.h).
#pragma once

#include "integrators/path/path_step.h"
#include "integrators/path/shared_lobe.h"
#include "renderer/material/bump.h"
#include "renderer/scene/scene.h"

namespace candela {

[[nodiscard]] inline const Material& material_of(const Scene& scene, std::uint32_t geometry) {
  return scene.materials[scene.geometries[geometry].material.index];
}

// Of materials that are not plain (plain_model.h) those with a diffuse lobe that can be shared: by
// coats that are smooth or of several widths, and by exact Fresnel terms.
[[nodiscard]] inline bool has_shared_lobe(const Material& material) {
  return material.model == MaterialModel::CoatedDiffuse ||
         (material.model == MaterialModel::CookTorrance && !material.energy_compensation);
}

// Whether what others' paths met can be met from there as well.
[[nodiscard]] inline bool receives_shared(const Scene& scene, std::uint32_t geometry) {
  switch (scene.plain_models[geometry]) {
    case PlainModel::Diffuse:
    case PlainModel::CookTorrance:
    case PlainModel::SmithCookTorrance:
    case PlainModel::Lab:
    case PlainModel::CoatedDiffuse:
      return true;
    case PlainModel::None:
      return scene.geometries[geometry].spheres.empty() &&
             !bounds_media(scene, scene.geometries[geometry].material) &&
             has_shared_lobe(material_of(scene, geometry));
    default:
      return false;
  }
}

[[nodiscard]] inline bool is_lambertian(const Scene& scene, std::uint32_t geometry) {
  return scene.plain_models[geometry] == PlainModel::Diffuse;
}

// Whether what a path meets there can serve others: what leaves its diffuse lobe is known in all
// directions but those from which its shading normal is bent (surface_point.h), which its geometry
// tells. What comes to a glossy one from several lights that are sampled at every hit could not be
// told apart.
[[nodiscard]] inline bool gives_shared(const Scene& scene, std::uint32_t geometry) {
  return receives_shared(scene, geometry) && !scene.geometries[geometry].is_emissive() &&
         (is_lambertian(scene, geometry) || scene.light_sampler.always().size() <= 1);
}

// The shading normal is the triangle's.
[[nodiscard]] inline bool has_flat_shading(const Scene& scene, std::uint32_t geometry) {
  return scene.geometries[geometry].normals.empty() && !has_bump(material_of(scene, geometry));
}

// Without coordinates, bumps and shading frame; on the side that `wo` is on.
[[nodiscard]] inline SurfacePoint bare_point_at(const Scene& scene, const Hit& hit,
                                                const Vec3f& wo) {
  const Instance* instance = hit.is_instanced() ? &scene.instances[hit.instance] : nullptr;
  return make_triangle_point(scene.geometries[hit.geometry], instance, hit, wo, false);
}

struct SurfaceMet {
  SurfacePoint point;
  Bsdf bsdf;
  SharedLobe lobe;
};
[[nodiscard]] inline SurfaceMet surface_met(const Scene& scene, const Hit& hit, const Vec3f& wo) {
  const Material& material = material_of(scene, hit.geometry);
  SurfaceMet met;
  met.point = surface_point_at<general_features>(scene, hit, material, wo);
  met.bsdf = bsdf_at(material, scene.textures, texture_point_of(met.point), met.point.is_front);
  met.lobe = shared_lobe_of(met.bsdf, dot(met.point.shading.z, wo));
  return met;
}

}  // namespace candela
