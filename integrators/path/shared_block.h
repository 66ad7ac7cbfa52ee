// Blocks that the samples of several pixels fill: where a pixel has fewer than sixteen, its own
// leave lanes empty, and a block takes nearly the same time however many of its lanes are filled.
//
// Which pixels share blocks follows from the picture alone: those of aligned squares, whatever tile
// or crop they are of (trace_block.h says why).
#pragma once

#include "integrators/path/block_trip.h"
#include "integrators/tile_pass.h"
#include "renderer/film/tiles.h"

namespace candela {

// Pixels of a square, each side: at one sample a pixel they fill a block.
inline constexpr int shared_side = 4;

// Whether pixels leave lanes empty in a pass.
[[nodiscard]] inline bool leaves_lanes_empty(const TilePass& pass) {
  return pass.density != nullptr || pass.range.first % block_size != 0 ||
         pass.range.end % block_size != 0;
}

// Whether the pass has blocks of several pixels' samples.
[[nodiscard]] inline bool shares_blocks(const RenderOptions& options, const TilePass& pass) {
  return options.savings.shares_blocks && pass.plan.splitting == 1 && pass.observer == nullptr &&
         leaves_lanes_empty(pass);
}

// Calls visit(square) for all aligned squares of a side that have a pixel in the tile, cut at the
// picture's edges.
template <class Visit>
inline void for_each_square(int side, const PixelRect& tile, int width, int height,
                            const Visit& visit) {
  const PixelRect first = square_around(tile.x0, tile.y0, side, width, height);
  for (int y = first.y0; y < tile.y1; y += side)
    for (int x = first.x0; x < tile.x1; x += side) visit(square_around(x, y, side, width, height));
}

// Calls visit(x, y) for the pixels of a square, neighbours after each other: in Morton order.
template <class Visit>
inline void for_each_pixel_near(const PixelRect& square, const Visit& visit) {
  for (int i = 0; i < shared_side * shared_side; ++i) {
    const int x = square.x0 + ((i & 1) | (i >> 1 & 2));
    const int y = square.y0 + ((i >> 1 & 1) | (i >> 2 & 2));
    if (x < square.x1 && y < square.y1) visit(x, y);
  }
}

// Samples one after the other until the block is full.
class SharedBlock {
 public:
  explicit SharedBlock(const RenderOptions& options) : place_{pixel_lanes_of(options), {}, 0} {}

  [[nodiscard]] bool is_empty() const { return size_ == 0; }
  [[nodiscard]] bool is_full() const { return size_ == block_size; }
  [[nodiscard]] const BlockPlace& place() const { return place_; }
  [[nodiscard]] SamplerBlock samplers() const { return SamplerBlock(sequences_); }

  void add(int x, int y, const PixelSampler& pixel, std::uint32_t sample) {
    set(size_++, x, y, pixel, sample);
  }
  // Into a lane, which need not be the next.
  void set(std::uint32_t lane, int x, int y, const PixelSampler& pixel, std::uint32_t sample) {
    place_.pixels.x[lane] = x;
    place_.pixels.y[lane] = y;
    place_.samples[lane] = sample;
    place_.lanes |= 1u << lane;
    sequences_.set(lane, pixel, sample);
    sequences_.order = pixel.order();
  }
  void clear() {
    size_ = 0;
    place_.lanes = 0;
  }

 private:
  std::uint32_t size_ = 0;
  BlockPlace place_;
  SequenceLanes sequences_;
};

}  // namespace candela
