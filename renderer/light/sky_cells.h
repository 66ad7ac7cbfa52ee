// The cells of a SkyDistribution, while they are made.
#pragma once

#include <functional>

#include "renderer/light/cell_weights.h"
#include "renderer/math/vec.h"

namespace candela {

// Of each column, in each of the rows `row` and `rows - 1 - row`.
[[nodiscard]] double sky_cell_solid_angle(GridSize size, std::uint32_t column, std::uint32_t row);

// The light of each of about `count` / `merged`^2 cells, twice as many columns as rows, by
// `merged`^2 points of each, or at least four. `luminance`: by unit direction; constant over
// patches of which there are about `count`. A cell of which no point has light, beside one that
// has, may yet be touched by the same patch and is given a little.
[[nodiscard]] CellWeights sky_cells(std::size_t count, std::uint32_t merged,
                                    const std::function<double(const Vec3f&)>& luminance);

}  // namespace candela
