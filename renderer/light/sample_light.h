// The questions a path asks of a light: one switch over the kinds for each.
//
//   sample_light      a direction towards a given light (next-event estimation)
//   emitted_radiance  what a ray sees that hits an emitting surface
// The radiance of rays that leave the scene is environment_radiance (environment.h). The density
// with which sample_light would have found what a path met is for who knows what that is: a sphere
// (sphere_light_pdf), the environment (environment_pdf), or a triangle, which may be half of a quad
// (path_step.h).
#pragma once

#include "renderer/light/directional_light.h"
#include "renderer/light/environment.h"
#include "renderer/light/image_light.h"
#include "renderer/light/light.h"
#include "renderer/light/point_light.h"
#include "renderer/light/quad_light.h"
#include "renderer/light/sphere_light.h"
#include "renderer/light/textured_triangle_light.h"
#include "renderer/light/triangle_light.h"

namespace candela {

// What lights refer to. The environment may be null where no light is one.
struct LightTables {
  const Environment* environment = nullptr;
  const TextureStore* textures = nullptr;
  const std::vector<Geometry>* geometries = nullptr;  // of textured lamps
};

[[nodiscard]] inline LightSample sample_environment_light(const LightTables& tables,
                                                          const SurfacePoint& from, Vec2f u) {
  EnvironmentSample sample = sample_environment(*tables.environment, u);
  if (!(sample.pdf > 0)) return {};
  Rgb radiance = environment_radiance(*tables.environment, *tables.textures, sample.direction);
  if (is_black(radiance)) return {};
  return {.wi = sample.direction,
          .radiance = radiance,
          .pdf = sample.pdf,
          .shadow_ray = spawn_ray(from, sample.direction)};
}

// Towards `light` from a surface; u in [0, 1)^2. The result is never NaN or Inf. Kernels pass the
// kinds that their scene has.
template <LightKindSet kinds = all_light_kinds>
[[nodiscard]] inline LightSample sample_light(const LightTables& tables, const Light& light,
                                              const SurfacePoint& from, Vec2f u) {
  switch (light.kind) {
    case LightKind::Point:
    case LightKind::Spot:
      return sample_point_light(light, from);
    case LightKind::Directional:
      return sample_directional_light(light, from);
    case LightKind::Triangle:
      return sample_triangle_light(light, from, u);
    case LightKind::Quad:
    case LightKind::NearTriangle:
      return sample_quad_light(light, from, u);
    case LightKind::Environment:
      if constexpr ((kinds & light_kind_bit(LightKind::Environment)) != 0)
        return sample_environment_light(tables, from, u);
      break;
    case LightKind::TexturedTriangle:
      return sample_textured_triangle_light(light, (*tables.geometries)[light.geometry],
                                            *tables.textures, from, u);
    case LightKind::Goniometric:
    case LightKind::Projection:
      return sample_image_light(light, *tables.textures, from);
    case LightKind::Sphere:
      // A copy: what a function out of line is given the address of leaves the registers.
      if constexpr ((kinds & light_kind_bit(LightKind::Sphere)) != 0)
        return sample_sphere_light(light, *tables.geometries, *tables.textures, SurfacePoint(from),
                                   u);
      break;
  }
  return {};
}

// Radiance that leaves an emitting triangle or sphere where a hit has (u, v) towards the unit
// direction wo (away from it). The side is told by the light's own vertices, as in sampling.
[[nodiscard]] inline Rgb emitted_radiance(const LightTables& tables, const Light& light, float u,
                                          float v, const Vec3f& wo) {
  if (light.kind == LightKind::Sphere)
    return sphere_light_radiance(light, *tables.geometries, *tables.textures,
                                 from_octahedron({u, v}), wo);
  Rgb radiance = triangle_light_radiance(light, wo);
  if (light.kind == LightKind::TexturedTriangle)
    radiance *=
        emission_factor(light, (*tables.geometries)[light.geometry], *tables.textures, u, v);
  return radiance;
}

}  // namespace candela
