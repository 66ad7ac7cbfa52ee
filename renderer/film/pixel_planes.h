// Numbers of the pixels of a rectangle, a plane for each, and sums over pixels near by: loops over
// a plane that become vectors (renderer/base/vector_widths.h).
//
// Planes lie in memory row by row, and a neighbour at a fixed distance is a fixed number of places
// away. Sums run on over the ends of rows: they are right where all pixels that they are of lie in
// the rectangle.
#pragma once

#include <array>
#include <vector>

namespace candela {

using Plane = std::vector<double>;
using Planes = std::array<Plane, 3>;  // by channel

// The mean of the 3x3 pixels around each. `width`: of the rectangle.
[[nodiscard]] Plane mean_of_nine(const Plane& plane, std::size_t width);

// The sum over the 9x9 pixels around each but for the one in the middle, for which nothing is
// subtracted: it may be larger than all others together.
[[nodiscard]] Plane sum_near_by(const Plane& plane, std::size_t width);

// Of grey levels, noise being mostly in phase over the channels: a pessimist's guess.
[[nodiscard]] Plane variance_in_phase(const Planes& variances);

[[nodiscard]] Plane product(const Plane& a, const Plane& b);

}  // namespace candela
