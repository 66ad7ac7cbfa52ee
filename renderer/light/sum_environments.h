// Several skies at once as the one that a scene has: their sum.
//
// Maps of one mapping, size and rotation whose texels are decoded before they are filtered are
// added texel by texel, which is the sum at every direction; constants are added to each texel. All
// other maps are resampled to one of equal areas with twice the texels of the finest along each
// side, 64 to 4096, whose axes are the finest's own, by directions a quarter of a texel apart
// (half a one where 4096 is the limit).
#pragma once

#include <span>

#include "renderer/light/environment.h"

namespace candela {

struct EnvironmentSum {
  Environment environment;
  int resampled_side = 0;  // texels along a side; 0: the sum is exact
};

// `maps`: at least one, none of them constant. The sum is a texture of the store; cameras see it as
// they see the first.
[[nodiscard]] EnvironmentSum sum_environments(const Vec3d& constant,
                                              std::span<const Environment> maps,
                                              TextureStore& textures);

}  // namespace candela
