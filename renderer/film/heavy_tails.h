// Where the stated error cannot be trusted: regions whose light comes in few, rare, strong samples,
// so that most of what there is may not have been met yet.
#pragma once

#include <vector>

#include "renderer/film/film.h"

namespace candela {

// Whether one replicate holds far more than its share of the i-th pixel's light: of four, half of
// it.
[[nodiscard]] bool is_dominated(const Film& film, std::size_t i);

// One flag a pixel of the crop, in rows from the top. Regions are blocks of 8x8 pixels: those in
// which one replicate holds most of the light, be it of the whole region or of most of its pixels;
// regions too dim to matter (a mean below 1e-4 of the picture's) are not among them.
[[nodiscard]] std::vector<bool> heavy_tail_mask(const Film& film);

}  // namespace candela
