// What images say of colours, from what they have stored (TextureStore::lookup_stored()), and what
// is made of it at surfaces, for all lanes at once.
#pragma once

#include "renderer/math/lanes.h"

namespace candela {

// The lab's gamma, in those lanes.
void decode_gamma(LaneMask lanes, Vec3Lanes& colours);
// The same, then clamped to [0, 1].
void decode_reflectance(LaneMask lanes, Vec3Lanes& colours);

// limit_reflectance().
void limit_reflectances(Vec3Lanes& diffuse, Vec3Lanes& specular);

}  // namespace candela
