// A hit as lab3's own shading sees it: place, normal, (kd, ks, exponent, alpha).
#pragma once

#include "integrators/whitted/lab_context.h"
#include "integrators/whitted/lab_surface.h"
#include "renderer/geometry/surface_point.h"
#include "renderer/material/bump.h"
#include "renderer/material/mixed_material.h"
#include "renderer/material/texture_point_of.h"

namespace candela {

// A hit, its material and its place.
struct LabPoint {
  const Geometry& geometry;
  const Material& material;
  SurfacePoint place;
  LabSurface surface;
  Vec3f normal;  // to shade with
};

[[nodiscard]] inline SurfacePoint lab_place(const Scene& scene, const Hit& hit, const Vec3f& wo) {
  const Instance* instance = instance_of(scene, hit);
  return make_surface_point(scene.geometries[hit.geometry], instance, hit, wo, true);
}

// As the lab's code interpolates vertex normals: neither unit nor turned to the viewer.
[[nodiscard]] inline Vec3f interpolated_normal(const Scene& scene, const Hit& hit,
                                               const SurfacePoint& place) {
  const Geometry& geometry = scene.geometries[hit.geometry];
  if (geometry.normals.empty()) return place.front_normal;
  const auto& [a, b, c] = geometry.triangles[hit.triangle];
  const auto vertex_normal = [&](std::uint32_t v) {
    const Vec3f& n = geometry.normals[v];
    return hit.is_instanced() ? normalize(scene.instances[hit.instance].normal(n)) : n;
  };
  const Vec3f n =
      vertex_normal(a) * (1 - hit.u - hit.v) + vertex_normal(b) * hit.u + vertex_normal(c) * hit.v;
  return length_squared(n) > 0 ? n : place.front_normal;  // zero: there is none here
}

// Normals are unit and on the side of wo unless the lab's own are asked for; a map's is unit.
[[nodiscard]] inline LabPoint lab_point_at(const Scene& scene, const LabRules& rules,
                                           const Hit& hit, const Vec3f& wo) {
  const Geometry& geometry = scene.geometries[hit.geometry];
  SurfacePoint place = lab_place(scene, hit, wo);
  const Material& worn = scene.materials[geometry.material.index];
  const Material& material =
      greater_part_of_mix(scene.materials, worn, scene.textures, texture_point_of(place));
  const bool is_bumped = rules.bump && has_bump(material);
  if (is_bumped) {
    place.front_normal = shading_normal_at(material, scene.textures, texture_point_of(place),
                                           place.front_normal, place.dpdu, place.dpdv);
    place.is_flat = false;
  }
  set_shading_frame(place, wo);
  const auto lab_normal = [&] {
    return is_bumped ? place.front_normal : interpolated_normal(scene, hit, place);
  };
  return {geometry, material, place,
          lab_surface_at(worn, material, scene.textures, texture_point_of(place)),
          rules.lab_normals ? lab_normal() : place.shading.z};
}

}  // namespace candela
