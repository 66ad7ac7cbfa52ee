// A direction drawn from an environment map, in the map's own axes.
#pragma once

#include "renderer/math/vec.h"

namespace candela {

struct MapSample {
  Vec3f direction{0};
  float pdf = 0;  // solid angle
};

}  // namespace candela
