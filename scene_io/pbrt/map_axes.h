// The axes of images that light comes from: a light's own space from its map's, in which candela's
// images of all directions lie with y up (renderer/description/scene_description.h).
#pragma once

#include "renderer/math/vec.h"

namespace candela::pbrt {

// The image's middle is up, along the light's y. Its own inverse.
inline const Mat3d light_from_goniometric_map(1, 0, 0, 0, 0, 1, 0, 1, 0);

// Of pbrt-v3's latitudes and longitudes: z is up, and the image's middle column looks along -x.
inline const Mat3d light_from_lat_long_map(0, -1, 0, 0, 0, 1, 1, 0, 0);

}  // namespace candela::pbrt
