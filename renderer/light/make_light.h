// Lights from what a scene says. Lengths are in normalised space.
#pragma once

#include <array>
#include <optional>

#include "renderer/geometry/sphere.h"
#include "renderer/light/light.h"

namespace candela {

[[nodiscard]] Light make_point_light(const Vec3f& position, const Rgb& intensity);

// `axis` of any length, outwards. 0 <= inner <= outer <= pi; equal angles make a hard edge.
[[nodiscard]] Light make_spot_light(const Vec3f& position, const Vec3d& axis, const Rgb& intensity,
                                    double inner_angle_radians, double outer_angle_radians);

// `world_from_map`: its columns are the map's axes, unit. Without a texture the intensity is the
// same everywhere. The mean luminance is left to the caller.
[[nodiscard]] Light make_goniometric_light(const Vec3f& position, const Mat3d& world_from_map,
                                           const Rgb& intensity, TextureHandle texture);

// `half_sides`: of the image at distance 1.
[[nodiscard]] Light make_projection_light(const Vec3f& position, const Mat3d& world_from_map,
                                          const Vec2d& half_sides, const Rgb& intensity,
                                          TextureHandle texture);

// `to_light` of any length.
[[nodiscard]] Light make_directional_light(const Vec3d& to_light, const Rgb& irradiance);

// Emits on the side of (v1 - v0) x (v2 - v0), or on both. Its area is 0 where the triangle has none
// or one that floats cannot hold: such a light is to be dropped.
[[nodiscard]] Light make_triangle_light(const std::array<Vec3f, 3>& vertices, const Rgb& radiance,
                                        bool emits_both_sides);

// Emits outwards, inwards where it faces that way, or both. Its area is 0 as with triangles.
[[nodiscard]] Light make_sphere_light(const Sphere& sphere, const Rgb& radiance,
                                      bool emits_both_sides);

// The parallelogram of these corners, one after the other around it; nothing where they are none
// within the rounding of floats. It emits as the triangle of the corners 0, 1 and 3. Rectangles may
// be sampled `by_solid_angle` from near.
[[nodiscard]] std::optional<Light> make_quad_light(const std::array<Vec3f, 4>& corners,
                                                   const Rgb& radiance, bool emits_both_sides,
                                                   bool by_solid_angle);

// Of a Triangle or TexturedTriangle: sampled by solid angle from near. `index`: its place in the
// table of lights.
void sample_by_solid_angle(Light& triangle, std::uint32_t index);

[[nodiscard]] Light make_environment_light();

}  // namespace candela
