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

[[nodiscard]] inline bool has_shared_lobe(const Material& material) {
  switch (material.model) {
    case MaterialModel::Diffuse:
    case MaterialModel::Lab:
    case MaterialModel::CoatedDiffuse:
      return true;
    case MaterialModel::CookTorrance:
      return !material.energy_compensation;
    case MaterialModel::Mirror:
    case MaterialModel::Conductor:
    case MaterialModel::Dielectric:
    case MaterialModel::ThinDielectric:
    case MaterialModel::DiffuseTransmission:
    case MaterialModel::CoatedConductor:
    case MaterialModel::Mix:
      return false;
  }
  return false;
}

// Whether what others' paths met can be met from there as well.
[[nodiscard]] inline bool receives_shared(const Scene& scene, std::uint32_t geometry) {
  const Geometry& met = scene.geometries[geometry];
  return met.spheres.empty() && !bounds_media(scene, met.material) &&
         has_shared_lobe(material_of(scene, geometry));
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
  const Instance* instance = instance_of(scene, hit);
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
