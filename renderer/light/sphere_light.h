// Spheres that emit in each direction of a side. From outside they are sampled by the cone of
// directions in which they are seen (sphere_cone.h), from within, and on them, uniformly by area.
// Out of line: most scenes have none.
#pragma once

#include <vector>

#include "renderer/geometry/geometry.h"
#include "renderer/light/light.h"
#include "renderer/light/shadow_segment.h"
#include "renderer/texture/texture.h"

namespace candela {

// The unit direction from the centre to where a hit lies is `direction` below.

// Radiance leaving towards the unit direction `wo`, which points away from the surface.
[[nodiscard]] Rgb sphere_light_radiance(const Light& light, const std::vector<Geometry>& geometries,
                                        const TextureStore& textures, Vec3f direction, Vec3f wo);

// The density in solid angle of the unit wi, which meets the sphere at `distance` in `direction`
// from its centre. 0 for the far side, seen from outside through holes of the near one.
[[nodiscard]] float sphere_light_pdf(const Light& light, Vec3f direction, Vec3f wi, float distance);

[[nodiscard]] LightSample sample_sphere_light(const Light& light,
                                              const std::vector<Geometry>& geometries,
                                              const TextureStore& textures,
                                              const SurfacePoint& from, Vec2f u);

}  // namespace candela
