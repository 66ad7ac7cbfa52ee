// Within how much of a pixel's mean the truth lies, with 95 %.
//
// A pixel's own variance comes from a few replicates, and where its light is rare it is small just
// where the mean is too low: Student's t over the own replicates holds the truth too seldom. The
// variance is therefore that of the pixel and its eight neighbours together.
#pragma once

#include <vector>

#include "renderer/film/film.h"

namespace candela {

// Half the interval's width by channel, in rows from the top of the crop; the mean is its middle. 0
// where nothing varies, or where fewer than two replicates hold samples and nothing is known.
[[nodiscard]] std::vector<Vec3d> pixel_intervals(const Film& film);

}  // namespace candela
