// A tile of samples that no scene made, for tests of the render loop.
#pragma once

#include "integrators/tile_counts.h"
#include "integrators/tile_pass.h"
#include "renderer/sampling/hash.h"

namespace candela::test {

// [0, 1)
[[nodiscard]] inline double unit_double(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

// `draw(bits, x, y)`: the grey radiance of a sample of a pixel from random bits, which are its own
// for each seed.
template <class Draw>
TileCounts synthetic_tile(const TilePass& pass, Film& film, Draw draw) {
  for (int y = pass.tile.y0; y < pass.tile.y1; ++y)
    for (int x = pass.tile.x0; x < pass.tile.x1; ++x) {
      const SampleRange range = pass.of_pixel(x, y);
      const std::uint64_t pixel =
          hash_pixel(pass.seed, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
      for (std::uint32_t s = range.first; s < range.end; ++s) {
        FilmSample sample;
        sample.radiance = Rgb(static_cast<float>(draw(mix_bits(pixel + s), x, y)));
        film.add(x, y, sample);
        film.add_cost(x, y, 1);
      }
    }
  return {};
}

}  // namespace candela::test
