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

// What comes from a patch or a part of one: luminance times solid angle.
struct SkyLight {
  Vec3f direction{0};  // unit, of its middle
  double flux = 0;
};
using AddSkyLight = std::function<void(const SkyLight&)>;

struct SkyLuminance {
  std::function<double(const Vec3f&)> at;             // of a unit direction; constant over a patch
  std::function<void(const AddSkyLight&)> lamps;      // of patches with much of the light, in parts
  std::function<void(const AddSkyLight&)> all_light;  // of all patches that have any
};

// Columns and rows of sky_cells().
[[nodiscard]] GridSize sky_size(const SkyPatches& patches, std::uint32_t merged);

// The light of each of about `patches.count` / `merged`^2 cells, twice as many columns as rows, by
// `merged`^2 points of each, or at least four; by more where patches are so narrow that light in
// many of them side by side could lie between the points. What lies between them all the same:
// lamps have at least their light, and cells without any have what all patches say. A cell that is
// still dark beside one that is not may yet be touched by the same patch and is given a little.
[[nodiscard]] CellWeights sky_cells(const SkyPatches& patches, std::uint32_t merged,
                                    const SkyLuminance& luminance);

}  // namespace candela
