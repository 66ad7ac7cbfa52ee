// What a pass takes of the pixels of a tile.
#pragma once

#include <array>

#include "integrators/path_plan.h"
#include "integrators/rounds.h"
#include "renderer/film/film.h"
#include "renderer/film/sample_density.h"

namespace candela {

class GuidingField;
class PathObserver;

// Of samples that share what their paths find (path/path_reuse.h) a group alone, and what they
// would be if they did not.
struct GroupTrial {
  std::uint64_t number = 0;  // modulo the groups of a square (path/reuse_groups.h), its place
  Film* alone = nullptr;     // gets the samples without what is shared
};

struct TilePass {
  PixelRect tile;
  SampleRange range;                       // of each pixel; with a density: of the mean over all
  const SampleDensity* density = nullptr;  // null: all pixels get the same
  std::uint64_t seed = 0;
  PathPlan plan{};                                // of the path kernel
  const GuidingField* guide = nullptr;            // null: paths are not guided
  PathObserver* observer = nullptr;               // who is told what paths do; null: nobody
  std::array<SampleDensity::Scales, 2> scales{};  // the density's, where the range begins and ends
  const GroupTrial* trial = nullptr;              // null: all groups

  void deal_out_by(const SampleDensity& by) {
    density = &by;
    scales = {by.scales(range.first), by.scales(range.end)};
  }

  // Half-open range of the pixel's own sample indices. Those of consecutive passes join.
  [[nodiscard]] SampleRange of_pixel(int x, int y) const {
    if (density == nullptr) return range;
    return {density->samples(x, y, scales[0]), density->samples(x, y, scales[1])};
  }
};

}  // namespace candela
