// An integrator's kernel, bound to what it reads.
#pragma once

#include <functional>
#include <string>

#include "integrators/tile_counts.h"
#include "integrators/tile_pass.h"
#include "renderer/film/film.h"

namespace candela {

// The samples of a pass into the film, those of a pixel in the same order in any tile.
using TileFunction = std::function<TileCounts(const TilePass&, Film&)>;

struct Kernel {
  std::string name;
  TileFunction render_tile;
  bool sees_nothing = false;  // what is rendered provably sees a black background alone
};

}  // namespace candela
