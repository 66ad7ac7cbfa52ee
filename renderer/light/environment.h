// Light from infinitely far away: a constant, six faces of a cube, a latitude-longitude map, or an
// equal-area octahedral one (sampling/equal_area.h).
//
// Directions: unit, world space. Maps are looked up bilinearly, as their textures' encodings say;
// stored values that are not finite or below 0 count as 0.
// Cube faces lie as OpenGL's cube maps lay them [OpenGL46, table 8.19], row 0 of the file at t = 0.
// Latitude-longitude: row 0 is +y of the map, the centre column looks along -z, and columns to the
// right of it turn towards +x: what a viewer with +y up sees. u = 1/2 + atan2(x, -z) / (2 pi).
//
// Sampling follows the luminance of the map on about as many cells as it has texels, or fewer
// (sky_distribution.h); a constant is sampled uniformly. Made by build_environment.h.
#pragma once

#include <array>
#include <cstdint>

#include "renderer/light/cube_map.h"
#include "renderer/light/image_radiance.h"
#include "renderer/light/sky_distribution.h"
#include "renderer/math/constants.h"
#include "renderer/math/lat_long_map.h"
#include "renderer/math/vec.h"
#include "renderer/sampling/equal_area.h"
#include "renderer/sampling/warp.h"

namespace candela {

enum class EnvironmentMapping : std::uint8_t { Constant, Cube, LatLong, EqualArea };

struct Environment {
  EnvironmentMapping mapping = EnvironmentMapping::Constant;
  bool is_seen_by_camera = true;
  Rgb scale{0};                        // the constant's radiance; a factor of maps
  std::array<TextureHandle, 6> faces;  // Cube: +X -X +Y -Y +Z -Z; else only [0]
  // Rows of an orthonormal matrix (a mirroring one is fine).
  std::array<Vec3f, 3> map_from_world{Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}};

  // Maps. Half a texel in uv, by face: lookups stay this far from the ends that do not wrap.
  std::array<Vec2f, 6> half_texel{};
  // Of polar axes (to_polar()). Without cells: black everywhere.
  SkyDistribution distribution;
  double mean_luminance = 0;  // over the sphere

  [[nodiscard]] bool is_constant() const { return mapping == EnvironmentMapping::Constant; }
  // A black environment is no light; it may still be what camera rays end in.
  [[nodiscard]] bool is_black() const { return !(mean_luminance > 0); }
};

struct EnvironmentSample {
  Vec3f direction{0};
  float pdf = 0;  // solid angle; 0: no sample
};

namespace environment_detail {

[[nodiscard]] inline Vec3f to_map(const Environment& e, const Vec3f& d) {
  return {dot(e.map_from_world[0], d), dot(e.map_from_world[1], d), dot(e.map_from_world[2], d)};
}
[[nodiscard]] inline Vec3f to_world(const Environment& e, const Vec3f& d) {
  return e.map_from_world[0] * d.x + e.map_from_world[1] * d.y + e.map_from_world[2] * d.z;
}
// The map's axes, turned so that +y is its pole: equal-area maps have it at +z.
[[nodiscard]] inline Vec3f to_polar(EnvironmentMapping mapping, const Vec3f& d) {
  return mapping == EnvironmentMapping::EqualArea ? Vec3f{d.x, d.z, -d.y} : d;
}
[[nodiscard]] inline Vec3f from_polar(EnvironmentMapping mapping, const Vec3f& d) {
  return mapping == EnvironmentMapping::EqualArea ? Vec3f{d.x, -d.z, d.y} : d;
}
// Rows of files count from the top, v from the bottom.
[[nodiscard]] inline Vec2f uv_of(Vec2f st) {
  return {st.x, 1 - st.y};
}

}  // namespace environment_detail

// Where a map's files have a direction.
struct EnvironmentPoint {
  std::uint32_t face = 0;
  Vec2f uv{0};  // of a place that the file's lookups mix with no texel beyond its ends
};

namespace environment_detail {

// Of a point on a map, from the top.
[[nodiscard]] inline EnvironmentPoint point_in_file(std::uint32_t face, Vec2f st, Vec2f least,
                                                    Vec2f most) {
  return {face, uv_of(glm::clamp(st, least, most))};
}
[[nodiscard]] inline EnvironmentPoint point_on_cube(const Environment& environment,
                                                    const Vec3f& direction) {
  const CubePoint point = cube_point(to_map(environment, direction));
  Vec2f inset = environment.half_texel[point.face];
  return point_in_file(point.face, point.st, inset, Vec2f(1) - inset);
}
// Columns wrap, rows do not.
[[nodiscard]] inline EnvironmentPoint point_on_lat_long(const Environment& environment,
                                                        const Vec3f& direction) {
  const float inset = environment.half_texel[0].y;
  return point_in_file(0, lat_long_point(to_map(environment, direction)), {0, inset},
                       {1, 1 - inset});
}
[[nodiscard]] inline EnvironmentPoint point_on_equal_area(const Environment& environment,
                                                          const Vec3f& direction) {
  Vec2f inset = environment.half_texel[0];
  return point_in_file(0, equal_area_sphere_to_square(to_map(environment, direction)), inset,
                       Vec2f(1) - inset);
}

}  // namespace environment_detail

[[nodiscard]] inline EnvironmentPoint environment_point(const Environment& environment,
                                                        const Vec3f& direction) {
  using namespace environment_detail;
  switch (environment.mapping) {
    case EnvironmentMapping::Constant:
      return {};
    case EnvironmentMapping::Cube:
      return point_on_cube(environment, direction);
    case EnvironmentMapping::LatLong:
      return point_on_lat_long(environment, direction);
    case EnvironmentMapping::EqualArea:
      return point_on_equal_area(environment, direction);
  }
  return {};
}

// Radiance arriving from a direction.
[[nodiscard]] inline Rgb environment_radiance(const Environment& environment,
                                              const TextureStore& textures,
                                              const EnvironmentPoint& point) {
  if (environment.is_constant()) return environment.scale;
  return environment.scale * image_radiance(textures, environment.faces[point.face], point.uv);
}
// Asks the memory for it, and waits for nothing.
inline void prefetch_radiance(const Environment& environment, const TextureStore& textures,
                              const EnvironmentPoint& point) {
  if (environment.is_constant()) return;
  textures.prefetch(environment.faces[point.face], point.uv);
}
[[nodiscard]] inline Rgb environment_radiance(const Environment& environment,
                                              const TextureStore& textures,
                                              const Vec3f& direction) {
  return environment_radiance(environment, textures, environment_point(environment, direction));
}

// The cell of a map's table that has a direction.
[[nodiscard]] inline SkyPlace environment_place(const Environment& environment,
                                                const Vec3f& direction) {
  using namespace environment_detail;
  return environment.distribution.place_of(
      to_polar(environment.mapping, to_map(environment, direction)));
}
// The density of sample_environment() at a direction.
[[nodiscard]] inline float environment_pdf(const Environment& environment, const Vec3f& direction) {
  if (environment.is_black()) return 0;
  if (environment.is_constant()) return inverse_pi * 0.25f;
  return environment.distribution.pdf(environment_place(environment, direction));
}

// A direction within a cell of a map's table.
[[nodiscard]] inline EnvironmentSample sample_in_cell(const Environment& environment,
                                                      const GridDistribution::Cell& cell) {
  using namespace environment_detail;
  const SkySample s = environment.distribution.at(cell);
  return {to_world(environment, from_polar(environment.mapping, s.direction)), s.pdf};
}
[[nodiscard]] inline EnvironmentSample sample_environment(const Environment& environment, Vec2f u) {
  if (environment.is_black()) return {};
  if (environment.is_constant()) return {square_to_uniform_sphere(u), inverse_pi * 0.25f};
  return sample_in_cell(environment, environment.distribution.cells().sample(u));
}

}  // namespace candela
