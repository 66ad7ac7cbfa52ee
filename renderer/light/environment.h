// Light from infinitely far away: a constant, six faces of a cube, or a latitude-longitude map.
#pragma once

#include <array>
#include <vector>

#include "renderer/math/vec.h"
#include "renderer/texture/texture.h"

namespace candela {

enum class EnvironmentMapping : std::uint8_t { Constant, Cube, LatLong };

// The density is proportional to the map's filtered luminance; a constant is sampled uniformly.
struct Environment {
  EnvironmentMapping mapping = EnvironmentMapping::Constant;
  bool is_seen_by_camera = true;
  Rgb scale{0};                        // the constant's radiance; a factor of maps
  std::array<TextureHandle, 6> faces;  // Cube: +X -X +Y -Y +Z -Z; LatLong: only [0]
  std::array<Vec3f, 3> map_from_world{Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}};  // rows
};

}  // namespace candela
