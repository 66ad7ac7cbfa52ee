// Samples of a block that are all of one pixel and keep nothing of their hits enter the film at
// once.
#pragma once

#include "integrators/path/block_place.h"
#include "integrators/tile_counts.h"

namespace candela {

// What add_or_count() (tile_counts.h) of one after the other does, bit by bit.
void add_or_count(const BlockPlace& place, const Vec3Lanes& radiance, const Lanes<float>& weight,
                  const Lanes<float>& alpha, float clamp, Film& film, TileCounts& counts);

}  // namespace candela
