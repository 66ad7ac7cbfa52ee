// Pixels of which the geometry proves that no camera ray meets anything: their samples are all the
// constant background, and no ray need be traced for them.
//
// What the bounds cover: every triangle's, or instance's box's, projection, widened by what
// rounding does to vertices and rays, and by the pixel filter's radius.
#pragma once

#include <cstdint>
#include <vector>

#include "integrators/render.h"
#include "renderer/film/filter.h"

namespace candela {

class BackgroundPixels {
 public:
  // Of the whole picture, for a camera of the scene. Without media around it; empty (no pixel is
  // proven) where the background is no constant, the filter has weights, the camera no projection,
  // or the scene more triangles than looking at them could spare.
  BackgroundPixels(const Scene& scene, const Filter& filter, const RenderOptions& options);

  [[nodiscard]] bool is_empty() const { return is_background_.empty(); }
  [[nodiscard]] bool contains(int x, int y) const {
    return !is_background_.empty() &&
           is_background_[static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x)] != 0;
  }
  // What each sample of these pixels brings.
  [[nodiscard]] const FilmSample& sample() const { return sample_; }

 private:
  std::size_t width_ = 0;
  std::vector<std::uint8_t> is_background_;  // in rows from the top
  FilmSample sample_;
};

}  // namespace candela
