// What the textures of a surface look at where a ray met it.
#pragma once

#include "renderer/geometry/surface_point.h"
#include "renderer/texture/texture_point.h"

namespace candela {

// The normal is the geometric one, on either side: bumps are made of textures themselves.
[[nodiscard]] inline TexturePoint texture_point_of(const SurfacePoint& point) {
  return {point.uv, point.position, point.geometric_normal};
}

}  // namespace candela
