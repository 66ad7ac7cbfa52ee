// An integrator's kernel, bound to what it reads. The render loop knows no more of an integrator.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "integrators/tile_counts.h"
#include "renderer/film/film.h"

namespace candela {

// Samples [first, end) of each pixel of a tile, in order, into the film.
using TileFunction =
    std::function<TileCounts(const PixelRect&, std::uint32_t first, std::uint32_t end, Film&)>;

struct Kernel {
  std::string name;
  TileFunction render_tile;
};

}  // namespace candela
