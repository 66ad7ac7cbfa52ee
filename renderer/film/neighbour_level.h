// What the radiance of a pixel is likely to be, as its neighbours have it: from those that look
// alike by more than chance, after non-local means with known variances [Rousselle12, section 4].
// Light that one replicate alone has met is kept apart (robust_mean.h): it would make pixels look
// alike that are not. Means and variances are those without it but for `own_variance` and `rare`.
#pragma once

#include <vector>

#include "renderer/film/film.h"

namespace candela {

// The pixel itself is left out everywhere: what is known of it can be added apart.
struct NeighbourLevel {
  Vec3d mean{0.0};          // over those that look alike
  Vec3d noise{0.0};         // variance of that mean
  Vec3d structure{0.0};     // variance of what they would be without noise
  Vec3d wide_mean{0.0};     // over all near by, whether they look alike or not
  Vec3d own_variance{0.0};  // of the pixel's own mean: at least that of those next to it
  Vec3d rare{0.0};          // rare light, over all near by: to be added
  Vec3d rare_noise{0.0};    // variance of that
  double company = 0;       // 0 where none of them looks alike, to 1 where some do
};

// Of the pixels of `block`, in rows from the top.
[[nodiscard]] std::vector<NeighbourLevel> neighbour_levels(const Film& film,
                                                           const PixelRect& block);

}  // namespace candela
