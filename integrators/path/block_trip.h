// Up to sixteen consecutive samples of a pixel on their way from the camera: their rays are traced
// together, then each path takes its step.
#pragma once

#include "integrators/path/branches.h"

namespace candela {

// Which samples a block has.
struct BlockPlace {
  int x;
  int y;
  std::uint32_t first;  // sample of the pixel
  LaneMask lanes;       // of the sixteen from there on
};

template <class A>
struct BlockTrip {
  BlockTrip(const PathContext<A>& context_there, const PixelSampler& sampler_there,
            const BlockPlace& where, std::uint32_t splitting, PathBlock& paths)
      : context(context_there),
        pixel(sampler_there),
        place(where),
        samplers(pixel, place.first),
        branches(pixel, place.first, splitting),
        block(paths) {}
  BlockTrip(const BlockTrip&) = delete;  // branches refer to its pixel
  BlockTrip& operator=(const BlockTrip&) = delete;

  // Of the paths that go on from the hits, and of the hits themselves.
  [[nodiscard]] const SamplerBlock& path_samplers() const { return branches.samplers(samplers); }
  [[nodiscard]] const SamplerBlock& hit_samplers() const {
    return bounce == 0 ? samplers : path_samplers();
  }

  const PathContext<A> context;  // as it is at the pixel
  const PixelSampler pixel;
  const BlockPlace place;
  const SamplerBlock samplers;
  Branches branches;
  PathBlock& block;

  std::uint32_t bounce = 0;
  LaneMask alive = 0;  // paths that are on their way
  LanesAfterStep after;
  BlockNumbers numbers;
  bool is_drawn_together = false;  // `numbers` holds those of the bounce
  TileCounts counts;
};

}  // namespace candela
