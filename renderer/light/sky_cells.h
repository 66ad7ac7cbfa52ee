// The cells of a SkyDistribution, while they are made.
#pragma once

#include <functional>

#include "renderer/light/cell_weights.h"
#include "renderer/math/vec.h"

namespace candela {

// Of each column, in each of the rows `row` and `rows - 1 - row`.
[[nodiscard]] double sky_cell_solid_angle(GridSize size, std::uint32_t column, std::uint32_t row);

// Patches of one colour: how many in all, around the pole, and from pole to pole.
struct SkyPatches {
  std::size_t count = 0;
  std::uint32_t around = 0;
  std::uint32_t down = 0;
};

// The light of each of about `patches.count` / `merged`^2 cells, twice as many columns as rows, by
// `merged`^2 points of each, or at least four; by more where patches are so narrow that light in
// two of them side by side could lie between the points. `luminance`: by unit direction, constant
// over the patches. A cell of which no point has light, beside one that has, may yet be touched by
// the same patch and is given a little.
[[nodiscard]] CellWeights sky_cells(const SkyPatches& patches, std::uint32_t merged,
                                    const std::function<double(const Vec3f&)>& luminance);

}  // namespace candela
