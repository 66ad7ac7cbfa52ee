// A tile's pixels through whitted or raster: samples lie at the centres of an n x n grid, which a
// box filter averages. Nothing is random.
#pragma once

#include "integrators/tile_counts.h"
#include "integrators/tile_pass.h"
#include "integrators/whitted/lab_context.h"

namespace candela {

// The side of the grid: n for n * n samples.
[[nodiscard]] inline std::uint32_t grid_side(int samples_per_pixel) {
  std::uint32_t side = 1;
  while (side * side < static_cast<std::uint32_t>(samples_per_pixel)) ++side;
  return side;
}

// Through the centre of the s-th cell of pixel (x, y), in rows from the top.
template <class A>
[[nodiscard]] inline Ray grid_ray(const LabContext<A>& context, int x, int y, std::uint32_t s,
                                  std::uint32_t side) {
  const auto cell = [side](std::uint32_t i) {
    return (static_cast<float>(i) + 0.5f) / static_cast<float>(side);
  };
  const Vec2f film{
      (static_cast<float>(x) + cell(s % side)) / static_cast<float>(context.options.width),
      (static_cast<float>(y) + cell(s / side)) / static_cast<float>(context.options.height)};
  return context.camera.generate_ray(film, Vec2f(0.5f));  // a lens is taken for its centre
}

// The samples of a pass, in order; `trace`: (context, ray, counts) -> FilmSample.
template <class A, class Trace>
TileCounts render_grid_tile(const LabContext<A>& context, Trace trace, const TilePass& pass,
                            Film& film) {
  const PixelRect& tile = pass.tile;
  const std::uint32_t side = grid_side(context.options.samples_per_pixel);
  TileCounts counts;
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int x = tile.x0; x < tile.x1; ++x)
      for (std::uint32_t s = pass.range.first; s < pass.range.end; ++s)
        add_or_count(trace(context, grid_ray(context, x, y, s, side), counts), x, y, s,
                     context.options.clamp, film, counts);
  return counts;
}

}  // namespace candela
