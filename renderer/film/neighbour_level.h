// What the radiance of a pixel is likely to be, as its neighbours have it: from those that look alike
// by more than chance, after non-local means with known variances [Rousselle12, section 4].
#pragma once

#include <vector>

#include "renderer/film/film.h"

namespace candela {

// A sum over neighbours, the pixel itself left out: what is known of it can be added apart.
struct NeighbourLevel {
  double weight = 0;
  Vec3d sum{0.0};       // of weight times mean
  Vec3d variance{0.0};  // of `sum`
  double all_weight = 0;  // over all neighbours near by, whether they look alike or not
  Vec3d all_sum{0.0};
  Vec3d own_variance{0.0};  // of the pixel's own mean, evened out with those next to it
};

// Of the pixels of `block`, in rows from the top.
[[nodiscard]] std::vector<NeighbourLevel> neighbour_levels(const Film& film,
                                                           const PixelRect& block);

}  // namespace candela
